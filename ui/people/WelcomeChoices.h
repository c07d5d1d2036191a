// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace ui::people {

/// The two buttons that a new user sees first: practise now, or set up a school.
class WelcomeChoices final : public QWidget
{
    Q_OBJECT
public:
    explicit WelcomeChoices(QWidget* parent);

signals:
    void practiceRequested();
    void schoolRequested();

private:
    /// A button with a title, and below it a line that explains the choice.
    struct Choice
    {
        QPushButton* button = nullptr;
        QLabel* title = nullptr;
        QLabel* words = nullptr;
    };
    Choice addChoice(const char* name, QVBoxLayout& column);
    void retranslateUi();

    Choice m_practise;
    Choice m_school;
};

}  // namespace ui::people
