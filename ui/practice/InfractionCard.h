// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QFrame>

#include "core/grading/RuleChecker.h"

class QBoxLayout;
class QLabel;
class QPushButton;

namespace ui::practice {

/// Shown over the tooth when a rule of the lesson has been broken in practice: what happened and why it matters, with
/// buttons to undo it or to continue. The bur is stopped meanwhile.
class InfractionCard final : public QFrame
{
    Q_OBJECT
public:
    explicit InfractionCard(QWidget* parent);

    /// Shows an infraction.
    /// @param canTakeBack  there is a stored moment before it
    void tell(const core::grading::Infraction& infraction, bool canTakeBack);
    /// Continues without undoing, like its button.
    void goOn();
    /// Undoes, like its button. Returns false if the button is not available.
    bool takeBack();
    /// Places the card at the bottom of `area`, or below its top if the card would cover the bur.
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

/// Returns the name of an infraction, such as "Pulp opened", with the value and its limit if there is one.
[[nodiscard]] QString breachName(const core::grading::Infraction& infraction);
/// Returns one sentence that says why the rule matters.
[[nodiscard]] QString breachReason(core::grading::RuleViolation breach);

}  // namespace ui::practice
