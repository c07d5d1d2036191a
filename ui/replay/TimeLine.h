// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QWidget>

#include "ui/replay/AttemptTimeline.h"

namespace ui::replay {

/// The time line of an attempt: strokes as bars coloured by bur, above them what else happened, infractions first of
/// all, what people have remarked, and the moment that is shown. Dragged, it goes there; a click on an infraction or a
/// remark goes to what led to it; pointed at, it says what is there. Beneath, with an axis of its own, another attempt
/// that is shown beside.
class TimeLine final : public QWidget
{
    Q_OBJECT
public:
    explicit TimeLine(QWidget* parent);

    void setCourse(const AttemptTimeline& course);
    /// @param beside  no strokes, no length: there is none
    void setBeside(const AttemptTimeline& beside);
    /// The moment that is shown.
    void setPosition(double seconds);
    [[nodiscard]] const AttemptTimeline& course() const { return m_course; }

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

    /// Where a moment is on the line, px.
    [[nodiscard]] double xOf(double seconds) const;
    /// What is there, a line each; empty: nothing but time.
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
    /// One attempt of the line, and where its lanes begin.
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

/// Colour of a bur, by its index in core::bur::burs(): no two burs have the same. Those of the common burs also
/// differ for people with colour blindness; the number of the bur is drawn beside each change of bur.
[[nodiscard]] QColor burColour(std::uint8_t index);
/// "Undone", "Bur 2: Pear, No. 330", "Handpiece: Turbine".
[[nodiscard]] QString markWords(const Mark& mark);
/// "Tina Teacher: here the wall leans in", shortened.
[[nodiscard]] QString remarkWords(const Remark& remark);

}  // namespace ui::replay
