// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>

namespace ui::kit {

/// The menu of languages, each in its own name. A chosen language is used at once and stored for the next run.
class LanguageMenu final : public QMenu
{
    Q_OBJECT
public:
    explicit LanguageMenu(QWidget* parent);

    /// Returns the code of the stored language; empty: none is stored.
    [[nodiscard]] static QString remembered();
    /// Switches the program to a language and stores it.
    static void choose(const QString& code);
};

}  // namespace ui::kit
