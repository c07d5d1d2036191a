// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <QCoreApplication>

#include "core/session/SessionChannels.h"

namespace ui::kit {
class MessageBar;
}

namespace ui::window {

/// Sends the user's commands to the session loop, and shows a message if the queue is full. Ui thread.
class CommandSender
{
    Q_DECLARE_TR_FUNCTIONS(ui::window::CommandSender)
public:
    /// @param links  must outlive the sender
    CommandSender(core::session::UiChannels& links, kit::MessageBar& messages) : m_links(links), m_messages(messages) {}

    /// Sends a command. Returns false if the queue is full.
    bool send(core::session::SessionCommand command);
    /// Returns whether this number of calls of send() in a row will succeed. Otherwise shows the message.
    [[nodiscard]] bool canSend(std::size_t commands);

private:
    core::session::UiChannels& m_links;
    kit::MessageBar& m_messages;
};

}  // namespace ui::window
