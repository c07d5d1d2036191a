// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QFrame>

#include "core/grading/RuleChecker.h"

class QBoxLayout;
class QLabel;
class QPushButton;

namespace ui::practice {

/// A card over the tooth, shown when a rule of the lesson has been violated in practice. It says what happened and why
/// it matters, and has buttons to undo or to continue. The bur is stopped while the card is visible.
class InfractionCard final : public QFrame
{
    Q_OBJECT
public:
    explicit InfractionCard(QWidget* parent);

    /// Shows a rule violation.
    /// @param canTakeBack  a moment before it is stored, so it can be undone
    void tell(const core::grading::Infraction& infraction, bool canTakeBack);
    /// Continues without undoing, as the button does.
    void goOn();
    /// Undoes, as the button does. Returns false if the button is disabled.
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

/// Returns the name of a rule violation, such as "Pulp opened", with the value and its limit if there is one.
[[nodiscard]] QString breachName(const core::grading::Infraction& infraction);
/// Returns one sentence that says why the rule matters.
[[nodiscard]] QString breachReason(core::grading::RuleViolation breach);

}  // namespace ui::practice
