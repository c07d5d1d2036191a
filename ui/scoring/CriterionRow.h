// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QAbstractButton>

#include "lessons/PointLossTimeline.h"

class QGridLayout;
class QLabel;

namespace ui::scoring {

/// One criterion of a score: its name, what was measured and what it cost; beneath, when that was lost, each moment a
/// button, and among the details the formula with its numbers. To choose a row is to ask where it was worst. The height
/// of a row does not depend on which one is chosen.
class CriterionRow final : public QAbstractButton
{
    Q_OBJECT
public:
    CriterionRow(const ::lessons::Criterion& criterion, ::lessons::Verdict verdict, QWidget* parent);

    [[nodiscard]] const ::lessons::Criterion& criterion() const { return m_criterion; }
    /// @param moments  as lessons::momentsOf() finds them
    void setMoments(const std::vector<::lessons::Moment>& moments);
    /// Shows how the points were worked out, too. Without details, a serious error that was not made hides.
    void setDetailed(bool detailed);
    /// Makes the row plain text: there is no tooth to show its worst place on.
    void bePlain();

signals:
    void momentRequested(double seconds);

protected:
    void paintEvent(QPaintEvent* event) override;
    /// Up and down choose the row before and after, whatever else they are keys of.
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void fillMoments(bool all);

    ::lessons::Criterion m_criterion;
    QLabel* m_worked = nullptr;
    QGridLayout* m_slot = nullptr;
    QWidget* m_chips = nullptr;
    std::vector<::lessons::Moment> m_moments;  ///< as they are read: neighbours together
};

/// Moments as a person reads them: those of one stroke, or of one stretch of waiting or pressing, that follow each
/// other within ten seconds become one.
[[nodiscard]] std::vector<::lessons::Moment> asRead(const std::vector<::lessons::Moment>& moments);

/// "−1.2 at 0:43, stroke 7".
[[nodiscard]] QString momentWords(const ::lessons::Moment& moment, const ::lessons::Criterion& criterion);

}  // namespace ui::scoring
