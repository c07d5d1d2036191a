// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QCommandLinkButton;

namespace ui::people {

/// The first thing a new user sees: practise now, or set up a school.
class WelcomeChoices final : public QWidget
{
    Q_OBJECT
public:
    explicit WelcomeChoices(QWidget* parent);

    /// Returns the choice that has the focus first.
    [[nodiscard]] QWidget* first() const;

signals:
    void practiceWanted();
    void schoolWanted();

private:
    void speak();

    QCommandLinkButton* m_practise;
    QCommandLinkButton* m_school;
};

}  // namespace ui::people
