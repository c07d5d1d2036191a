// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include <QElapsedTimer>
#include <QPointF>
#include <QTimer>

#include "ui/render/ArchRenderer.h"
#include "ui/render/SharedArch.h"
#include "ui/tooth/Camera.h"
#include "ui/tooth/MouthScene.h"
#include "ui/tooth/SceneWidget.h"

namespace ui::toothchooser {

/// The whole mouth in 3D, to select one of the sixteen teeth of the left side by hovering, clicking or the arrow keys.
/// In a steep view from above or below, the jaw that would hide the other is not drawn.
///
/// Mouse: a click selects, a double click chooses the tooth. Dragging with the right or middle button turns the view,
/// and the wheel zooms.
/// Keys: arrows move along the arch and between the jaws, Enter chooses the tooth, Ctrl + arrows turn the view, plus
/// and minus zoom, Home resets the view.
///
/// Create it only if isPossible(). ArchView does the same without OpenGL. The meshes are built when the widget is first
/// shown.
class Mouth : public tooth::SceneWidget
{
    Q_OBJECT
public:
    explicit Mouth(QWidget* parent);
    ~Mouth() override;

    /// Returns whether this computer has OpenGL 3.3.
    [[nodiscard]] static bool isPossible();

    void setSelected(int fdi);  ///< 0: none
    /// Sets reduced motion: zooms without animation.
    void setMovesLittle(bool little) { m_movesLittle = little; }
    [[nodiscard]] int selected() const { return m_selected; }
    [[nodiscard]] int hovered() const { return m_hovered; }
    /// Returns whether the teeth have been built.
    [[nodiscard]] bool isReady() const { return m_arch != nullptr; }
    [[nodiscard]] const tooth::Camera& camera() const { return m_camera; }
    /// Returns the middle of a tooth's crown in widget coordinates.
    [[nodiscard]] QPointF placeOf(int fdi) const;

signals:
    void selectionChanged(int fdi);
    /// Emitted on a double click or Enter.
    void toothActivated(int fdi);
    void ready();

protected:
    [[nodiscard]] bool prepareScene(QString& reason) override;
    void releaseScene() override;
    void drawScene(QSize sizePx, int samples) override;
    void paintMarks(QPainter& painter) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    void take(const render::ArchPointer& arch);
    void select(int fdi);
    void walkTo(int fdi);
    void hover(int fdi);
    void turn(double azimuthDeg, double elevationDeg);
    void zoom(double steps);
    void showJaws();
    [[nodiscard]] int toothAt(QPointF position) const;
    [[nodiscard]] render::ArchScene scene() const;
    [[nodiscard]] const core::teeth::ArchPiece* pieceOf(int fdi) const;

    render::ArchPointer m_arch;
    std::vector<core::teeth::ArchPiece> m_pieces;  ///< pieces of both jaws
    std::vector<core::teeth::ArchPiece> m_shown;   ///< those of the jaws drawn now
    std::unique_ptr<render::ArchRenderer> m_renderer;
    bool m_piecesAreNew = false;  ///< not passed to the renderer yet
    tooth::Camera m_camera;
    int m_selected = 0;
    int m_hovered = 0;
    tooth::Jaws m_jawsShown;
    bool m_fitted = true;  ///< the distance follows the size of the widget until the user zooms
    bool m_movesLittle = false;

    QTimer m_zooming;
    QElapsedTimer m_sinceZoom;
    Qt::MouseButton m_turning = Qt::NoButton;
    QPointF m_turnedAt;
};

}  // namespace ui::toothchooser
