// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>

namespace ui::kit {

/// The languages, each named in itself. The one that is chosen is spoken at once, and at the next start.
class LanguageMenu final : public QMenu
{
    Q_OBJECT
public:
    explicit LanguageMenu(QWidget* parent);

    /// The code of the language that was chosen in the run before; empty: none was.
    [[nodiscard]] static QString remembered();
    /// From now on, and in the next run.
    static void choose(const QString& code);
};

}  // namespace ui::kit
