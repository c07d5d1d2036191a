// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <cstdint>
#include <memory>

#include <QElapsedTimer>
#include <QImage>
#include <QString>
#include <QTimer>
#include <QWidget>

class QPainter;

namespace ui::render {
class Canvas;
}

namespace ui::tooth {

class ScenePane;

/// A widget that draws its picture with OpenGL 3.3 and paints marks over it. Shows a sentence instead if there is no
/// OpenGL.
///
/// With a graphics card this uses a QOpenGLWidget. Qt then composes the whole window by OpenGL for every picture. For a
/// software driver that is most of the work (20 ms of processor time at 1280 x 800, ten times the cost of reading a
/// picture back), so there the picture is drawn off screen and painted as an image. A software driver draws without
/// anti-aliasing while something moves, and at half the resolution while the eye moves; it draws the smooth picture
/// after a pause.
///
/// Ui thread.
class SceneWidget : public QWidget
{
    Q_OBJECT

public:
    enum class Way : std::uint8_t { Window, Image };  ///< how pictures are shown on the screen
    [[nodiscard]] static Way bestWay();

    /// @param whyNot  returns the sentence for a computer without OpenGL 3.3
    SceneWidget(std::function<QString()> whyNot, Way way, QWidget* parent);
    ~SceneWidget() override;

    [[nodiscard]] Way way() const { return m_pane != nullptr ? Way::Window : Way::Image; }
    /// Returns false if there is no OpenGL 3.3 or the driver does not support the scene.
    [[nodiscard]] bool isUsable() const { return m_whyNot == nullptr; }
    /// Returns the current picture with anti-aliasing, in device pixels; the sentence if the widget is not usable.
    [[nodiscard]] QImage grabPicture();
    /// Schedules a new picture. QWidget::update() would not do: a child may draw it.
    void redraw();
    /// Schedules a new picture while the eye moves.
    void redrawMoving();
    /// Draws a new picture at once.
    void redrawNow();

signals:
    /// Emitted when a picture has been shown.
    void shown();

protected:
    /// Creates what drawScene() needs in the current context, which is also current in drawScene(). Returns false on
    /// failure, with the cause in `reason`.
    [[nodiscard]] virtual bool prepareScene(QString& reason) = 0;
    /// Releases all that prepareScene() created, because the context is about to be destroyed. A window that moves to
    /// another screen may get another context.
    virtual void releaseScene() = 0;
    /// Draws the scene into the bound framebuffer, all of its pixels.
    /// @param samples  per pixel; 0: no anti-aliasing
    virtual void drawScene(QSize sizePx, int samples) = 0;
    /// Paints marks over the picture, in widget coordinates.
    virtual void paintMarks(QPainter& painter) = 0;

    /// Releases the scene. Must be called first in the destructor of the derived class.
    void leave();
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    friend class ScenePane;
    void fail(const QString& detail);
    [[nodiscard]] const QImage* draw(int samples, int coarse = 1);

    std::unique_ptr<render::Canvas> m_canvas;  ///< for Way::Image, once a picture was drawn
    ScenePane* m_pane = nullptr;               ///< for Way::Window; otherwise null
    QWidget* m_whyNot = nullptr;               ///< shown instead of a picture that cannot be drawn
    std::function<QString()> m_sentence;
    QTimer m_still;  ///< runs until the smooth picture
    bool m_smoothWanted = false;
    QElapsedTimer m_sinceEyeMoved;
};

}  // namespace ui::tooth
