// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/CommandSender.h"

#include <utility>

#include "ui/kit/MessageBar.h"

namespace ui::window {

bool CommandSender::send(core::session::SessionCommand command)
{
    return canSend(1) && m_links.commands.tryPush(std::move(command));
}

bool CommandSender::canSend(std::size_t commands)
{
    // This thread is the only sender, so the room in the queue cannot shrink before send() is called.
    if (m_links.commands.space() >= commands)
        return true;
    m_messages.say(
        {kit::MessageBar::Kind::Warning, tr("Cusp was still busy and did not do that. Try again."), {}, {}, {}});
    return false;
}

}  // namespace ui::window
