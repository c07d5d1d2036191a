// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QAbstractButton>

#include "lessons/PointLossTimeline.h"

class QGridLayout;
class QLabel;

namespace ui::scoring {

/// One criterion of a score: its name, what was measured and what it cost. Below are the moments at which points were
/// lost, each a button, and in the details the formula with its numbers. Selecting a row shows the worst place of the
/// tooth. The height of a row does not depend on the selection.
class CriterionRow final : public QAbstractButton
{
    Q_OBJECT
public:
    CriterionRow(const ::lessons::Criterion& criterion, ::lessons::Verdict verdict, QWidget* parent);

    [[nodiscard]] const ::lessons::Criterion& criterion() const { return m_criterion; }
    /// @param moments  as returned by lessons::momentsOf()
    void setMoments(const std::vector<::lessons::Moment>& moments);
    /// Shows or hides the formulas. Without them, the row of a serious error that was not made is hidden.
    void setDetailed(bool detailed);
    /// Turns the row into plain text. Used if there is no tooth to show its worst place.
    void bePlain();

signals:
    void momentRequested(double seconds);

protected:
    void paintEvent(QPaintEvent* event) override;
    /// Claims the up and down keys, which select the previous and the next row, from other shortcuts.
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void fillMoments(bool all);

    ::lessons::Criterion m_criterion;
    QLabel* m_worked = nullptr;
    QGridLayout* m_slot = nullptr;
    QWidget* m_chips = nullptr;
    std::vector<::lessons::Moment> m_moments;  ///< merged by asRead()
};

/// Merges moments for display: moments of one stroke, one wait or one press that follow each other within ten seconds.
[[nodiscard]] std::vector<::lessons::Moment> asRead(const std::vector<::lessons::Moment>& moments);

/// Returns a text such as "−1.2 at 0:43, stroke 7".
[[nodiscard]] QString momentWords(const ::lessons::Moment& moment, const ::lessons::Criterion& criterion);

}  // namespace ui::scoring
