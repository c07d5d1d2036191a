// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>

namespace ui::kit {

/// The menu of languages, each with its own name. A selected language takes effect at once and is stored for the next
/// run.
class LanguageMenu final : public QMenu
{
    Q_OBJECT
public:
    explicit LanguageMenu(QWidget* parent);

    /// Returns the code of the stored language. Empty if none is stored.
    [[nodiscard]] static QString remembered();
    /// Switches the program to a language and stores it.
    static void choose(const QString& code);
};

}  // namespace ui::kit
