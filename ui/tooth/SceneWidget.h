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

/// A widget whose picture OpenGL 3.3 draws, with marks painted over it. Where there is no OpenGL, a sentence stands in
/// its place.
///
/// For a graphics card this is a QOpenGLWidget. With one in it, Qt puts the whole window together by OpenGL once more
/// for every picture. For a software driver that is most of the work (20 ms of processor time at 1280 x 800, ten times
/// what it takes to read a picture back), so there the picture is drawn aside and laid on the window as an image.
/// Such a driver draws moving pictures with hard edges, and smooth ones once nothing has moved for a while; while the
/// eye moves, and all of the picture with it, half as fine.
///
/// Ui thread.
class SceneWidget : public QWidget
{
    Q_OBJECT

public:
    enum class Way : std::uint8_t { Window, Image };  ///< on which pictures come to the screen
    [[nodiscard]] static Way bestWay();

    /// @param whyNot  says the sentence for a computer without OpenGL 3.3
    SceneWidget(std::function<QString()> whyNot, Way way, QWidget* parent);
    ~SceneWidget() override;

    [[nodiscard]] Way way() const { return m_pane != nullptr ? Way::Window : Way::Image; }
    /// False: this computer gives no OpenGL 3.3, or its driver refuses what is asked of it.
    [[nodiscard]] bool isUsable() const { return m_whyNot == nullptr; }
    /// What is shown now, with smooth edges, in device pixels; of a widget that is not usable its sentence.
    [[nodiscard]] QImage grabPicture();
    /// Shows a new picture as soon as Qt paints again. QWidget::update() would not do: what draws may be a child.
    void redraw();
    /// The same for an eye that moves.
    void redrawMoving();
    /// At once.
    void redrawNow();

signals:
    /// A picture has come to the window.
    void shown();

protected:
    /// Makes what drawScene() needs, in the context that is current in it, too. False when something is refused;
    /// `reason` then says what.
    [[nodiscard]] virtual bool prepareScene(QString& reason) = 0;
    /// Gives all of it back: that context goes. A window moved to another screen may bring another one.
    virtual void releaseScene() = 0;
    /// Into the bound framebuffer, all of its pixels.
    /// @param samples  of each pixel of that; 0: edges are hard
    virtual void drawScene(QSize sizePx, int samples) = 0;
    /// Over the picture, in coordinates of the widget.
    virtual void paintMarks(QPainter& painter) = 0;

    /// To be called first of all in the destructor of the class that draws.
    void leave();
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    friend class ScenePane;
    void fail(const QString& detail);
    [[nodiscard]] const QImage* draw(int samples, int coarse = 1);

    std::unique_ptr<render::Canvas> m_canvas;  ///< of a picture that comes as an image, once one was drawn
    ScenePane* m_pane = nullptr;               ///< what shows pictures otherwise
    QWidget* m_whyNot = nullptr;               ///< stands in the place of a picture that cannot be drawn
    std::function<QString()> m_sentence;
    QTimer m_still;  ///< nothing has moved for a while
    bool m_smoothWanted = false;
    QElapsedTimer m_sinceEyeMoved;
};

}  // namespace ui::tooth
