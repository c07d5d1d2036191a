// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QFrame>

#include "core/grading/RuleChecker.h"

class QBoxLayout;
class QLabel;
class QPushButton;

namespace ui::practice {

/// Over the tooth when a rule of the lesson has been broken in practice: what happened and why it matters, in two
/// sentences, and the choice to take it back or to go on. The bur rests meanwhile.
class InfractionCard final : public QFrame
{
    Q_OBJECT
public:
    explicit InfractionCard(QWidget* parent);

    /// @param canTakeBack  there is a moment before it to go back to
    void tell(const core::grading::Infraction& infraction, bool canTakeBack);
    /// As its button: leaves it as it is.
    void goOn();
    /// As its other button; false where it is not there to be pressed.
    bool takeBack();
    /// Puts the card at the foot of `area`, or below its top where the card would lie over the bur.
    void placeIn(const QRect& area, const std::optional<QPointF>& bur);

signals:
    void takeBackRequested();
    void goOnRequested();

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void retranslateUi();

    std::optional<core::grading::Infraction> m_told;
    QLabel* m_what = nullptr;
    QLabel* m_why = nullptr;
    QBoxLayout* m_buttons = nullptr;
    QPushButton* m_takeBack = nullptr;
    QPushButton* m_goOnButton = nullptr;
};

/// "Pulp opened", with the value against the limit where there is one.
[[nodiscard]] QString breachName(const core::grading::Infraction& infraction);
/// Why it matters, in one sentence.
[[nodiscard]] QString breachReason(core::grading::RuleViolation breach);

}  // namespace ui::practice
