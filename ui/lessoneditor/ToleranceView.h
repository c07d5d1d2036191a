// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <QWidget>

#include "ui/lessoneditor/LessonDraft.h"

namespace ui::lessoneditor {

/// What the tolerances of a draft mean on its tooth: from above a band beside the ideal's outline, and in section one
/// between the limits of its depth. Where the line of the section runs is dragged; a double click, the arrow keys and
/// the wheel turn it.
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
