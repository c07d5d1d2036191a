// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <QWidget>

#include "ui/lessoneditor/LessonDraft.h"

namespace ui::lessoneditor {

/// Shows the tolerances of a draft on its tooth: from above as a band around the outline of the ideal, and in a section
/// as a band between the depth limits. The user drags the line of the section, and turns it by a double click, the
/// arrow keys or the wheel.
class ToleranceView : public QWidget
{
    Q_OBJECT
public:
    explicit ToleranceView(QWidget* parent);

    void show(std::shared_ptr<const EvaluatedDraft> weighed);
    [[nodiscard]] QSize sizeHint() const override { return {720, 420}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {300, 180}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    [[nodiscard]] QRectF aboveArea() const;
    [[nodiscard]] QRectF sectionArea() const;
    void turn(double degrees);
    void drag(const QPointF& place);

    std::shared_ptr<const EvaluatedDraft> m_weighed;
    std::optional<core::terrain::Tooth> m_whole;
    core::imaging::SectionPlane m_plane;
};

}  // namespace ui::lessoneditor
