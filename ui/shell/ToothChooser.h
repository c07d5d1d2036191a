// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/shell/Page.h"

class QPushButton;

namespace ui::shell {

class ArchView;

/// The page on which another tooth is chosen: the arches, what is chosen in words, and the way to a scan of one's own.
class ToothChooser : public Page
{
    Q_OBJECT
public:
    ToothChooser(const Actions& actions, QWidget* parent);

    /// The tooth now on the table; 0 for a scan without a number.
    void setPresent(int fdi);

signals:
    void toothChosen(int fdi);

protected:
    void showEvent(QShowEvent* event) override;

private:
    void describe(int fdi);

    ArchView* m_arches;
    QLabel* m_number;
    QLabel* m_name;
    QLabel* m_note;
    QPushButton* m_take;
    int m_present = 0;
};

}  // namespace ui::shell
