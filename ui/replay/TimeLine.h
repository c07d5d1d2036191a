// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QWidget>

#include "ui/replay/AttemptTimeline.h"

namespace ui::replay {

/// The time line of an attempt: strokes as bars coloured by bur; above them other events, with rule violations in
/// front, and comments; and the current moment. Dragging seeks. A click on a rule violation or a comment seeks to
/// kLeadUpS before it. A tooltip describes the event under the pointer. An attempt shown for comparison is below, with
/// its own axis.
class TimeLine final : public QWidget
{
    Q_OBJECT
public:
    explicit TimeLine(QWidget* parent);

    void setCourse(const AttemptTimeline& course);
    /// @param beside  attempt for comparison; length 0: none
    void setBeside(const AttemptTimeline& beside);
    /// Sets the current moment.
    void setPosition(double seconds);
    [[nodiscard]] const AttemptTimeline& course() const { return m_course; }

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

    /// Returns the position of a moment on the line, px.
    [[nodiscard]] double xOf(double seconds) const;
    /// Returns the events at a position, one per line. Empty if there are none.
    [[nodiscard]] QStringList saidAt(const QPoint& place) const;

signals:
    void seekRequested(double seconds);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    bool event(QEvent* event) override;

private:
    /// One attempt on the time line, and the top of its lanes.
    struct Lane
    {
        const AttemptTimeline& course;
        int top;
    };

    [[nodiscard]] QList<Lane> lanes() const;
    [[nodiscard]] double xIn(const AttemptTimeline& course, double seconds) const;
    [[nodiscard]] double secondsAt(double x) const;
    void paintLane(QPainter& painter, const Lane& lane) const;
    void paintMarks(QPainter& painter, const Lane& lane) const;
    void paintScale(QPainter& painter) const;
    void paintNow(QPainter& painter) const;

    AttemptTimeline m_course;
    AttemptTimeline m_beside;
    double m_positionS = 0.0;
    bool m_scrubs = false;
};

/// Returns the colour of a bur by its index in core::bur::burs(). All burs have different colours. Those of the common
/// burs are also distinct for users with colour blindness, and the number of the bur is drawn at each change of bur.
[[nodiscard]] QColor burColour(std::uint8_t index);
/// Returns a text such as "Undone", "Bur 2: Pear, No. 330" or "Handpiece: Turbine".
[[nodiscard]] QString markWords(const Mark& mark);
/// Returns a comment with its author, elided: "Tina Teacher: here the wall leans in".
[[nodiscard]] QString remarkWords(const Remark& remark);

}  // namespace ui::replay
