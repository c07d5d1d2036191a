// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tooth/SceneWidget.h"

#include <utility>

#include <QCoreApplication>
#include <QEvent>
#include <QLabel>
#include <QOpenGLContext>
#include <QOpenGLWidget>
#include <QPainter>
#include <QVBoxLayout>

#include "ui/kit/LineIcon.h"
#include "ui/kit/Theme.h"
#include "ui/render/Canvas.h"
#include "ui/render/Driver.h"
#include "ui/text/EveryLanguage.h"

namespace ui::tooth {
namespace {

constexpr int kStillMs = 120;
constexpr int kCoarse = 2;
constexpr int kWhyNotIconPx = 56;
constexpr int kWhyNotWidthPx = 520;

}  // namespace

/// Shows the scene drawn by a graphics card. Passes mouse and key events on to its parent.
class ScenePane final : public QOpenGLWidget
{
public:
    explicit ScenePane(SceneWidget& scene) : QOpenGLWidget(&scene), m_scene(scene)
    {
        setFormat(render::wantedFormat());
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setFocusPolicy(Qt::NoFocus);
        connect(this, &QOpenGLWidget::frameSwapped, &scene, &SceneWidget::shown);
    }
    ~ScenePane() override
    {
        if (context() != nullptr)
            disconnect(context(), nullptr, this, nullptr);
        release();
    }

protected:
    void initializeGL() override
    {
        connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &ScenePane::release);
        m_prepared = true;
        if (QString reason; !m_scene.prepareScene(reason))
            m_scene.fail(reason);
    }
    void paintGL() override
    {
        if (!m_scene.isUsable())
            return;
        m_scene.drawScene(size() * devicePixelRatioF(), format().samples());
        QPainter painter(this);
        m_scene.paintMarks(painter);
    }

private:
    void release()
    {
        if (!std::exchange(m_prepared, false))
            return;
        makeCurrent();
        m_scene.releaseScene();
        doneCurrent();
    }

    SceneWidget& m_scene;
    bool m_prepared = false;
};

SceneWidget::Way SceneWidget::bestWay()
{
    return render::driver().isSoftware ? Way::Image : Way::Window;
}

SceneWidget::SceneWidget(std::function<QString()> whyNot, Way way, QWidget* parent)
    : QWidget(parent), m_sentence(std::move(whyNot))
{
    m_still.setSingleShot(true);
    m_still.setInterval(kStillMs);
    connect(&m_still, &QTimer::timeout, this, [this] {
        m_smoothWanted = true;
        redraw();
    });
    if (!render::driver().hasOpenGl33) {
        fail(QStringLiteral("no context of version 3.3 with a core profile could be made"));
    } else if (way == Way::Window) {
        m_pane = new ScenePane(*this);
    } else {
        setAttribute(Qt::WA_OpaquePaintEvent);
    }
}

SceneWidget::~SceneWidget() = default;

void SceneWidget::leave()
{
    delete std::exchange(m_pane, nullptr);
    if (m_canvas) {
        m_canvas->makeCurrent();
        releaseScene();
        m_canvas.reset();
    }
}

void SceneWidget::redraw()
{
    if (m_pane != nullptr)
        m_pane->update();
    else
        update();
}

void SceneWidget::redrawMoving()
{
    m_sinceEyeMoved.start();
    redraw();
}

void SceneWidget::redrawNow()
{
    redraw();
    QCoreApplication::sendPostedEvents(window(), QEvent::UpdateRequest);
}

/// Returns a picture drawn off screen, or null if that is not possible.
/// @param coarse  screen pixels per pixel of the picture, along one side
const QImage* SceneWidget::draw(int samples, int coarse)
{
    const QSize size = (this->size() * devicePixelRatioF() / coarse).expandedTo({1, 1});
    if (!m_canvas) {
        auto canvas = render::Canvas::make(size);
        if (!canvas) {
            fail(QString::fromStdString(canvas.error().detail));
            return nullptr;
        }
        m_canvas = std::move(*canvas);
        if (QString reason; !prepareScene(reason)) {
            fail(reason);
            return nullptr;
        }
    }
    m_canvas->resize(size);
    return &m_canvas->picture([&] { drawScene(size, samples); }, samples);
}

QImage SceneWidget::grabPicture()
{
    if (m_pane != nullptr && isUsable())
        return m_pane->grabFramebuffer().convertToFormat(QImage::Format_RGB32);
    const QImage* drawn = isUsable() ? draw(render::Canvas::kSamples) : nullptr;
    if (drawn == nullptr)
        return grab().toImage();
    QImage image = *drawn;
    image.setDevicePixelRatio(devicePixelRatioF());
    QPainter painter(&image);
    paintMarks(painter);
    painter.end();
    image.setDevicePixelRatio(1.0);
    return image;
}

bool SceneWidget::event(QEvent* event)
{
    // Ignores input while there is no picture that the user could act on.
    if (event->isInputEvent() && !isUsable()) {
        event->ignore();
        return false;
    }
    return QWidget::event(event);
}

void SceneWidget::paintEvent(QPaintEvent* /*event*/)
{
    if (m_pane != nullptr)
        return;
    const bool smooth = std::exchange(m_smoothWanted, false);
    // Pictures stay coarse for a while after the eye has moved. Otherwise those that only a moving bur requests would
    // be fine in between.
    const bool coarse = !smooth && m_sinceEyeMoved.isValid() && m_sinceEyeMoved.elapsed() < kStillMs;
    const QImage* drawn = isUsable() ? draw(smooth ? render::Canvas::kSamples : 0, coarse ? kCoarse : 1) : nullptr;
    QPainter painter(this);
    if (drawn == nullptr) {
        painter.fillRect(rect(), kit::roomPalette().window());
        return;
    }
    painter.setRenderHint(QPainter::SmoothPixmapTransform, coarse);
    painter.drawImage(QRectF(QPointF(), QSizeF(drawn->size()) * (coarse ? kCoarse : 1) / devicePixelRatioF()), *drawn);
    paintMarks(painter);
    if (!smooth)
        m_still.start();
    // Queued: the window system has the picture once this event has been handled.
    QMetaObject::invokeMethod(this, &SceneWidget::shown, Qt::QueuedConnection);
}

void SceneWidget::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    if (m_pane != nullptr)
        m_pane->setGeometry(rect());
    if (m_whyNot != nullptr)
        m_whyNot->setGeometry(rect());
}

/// Shows an error instead of the picture. Its background is dark in both themes.
void SceneWidget::fail(const QString& detail)
{
    qWarning("No picture of a tooth can be drawn: %s.", qPrintable(detail));
    m_whyNot = new QWidget(this);
    m_whyNot->setPalette(kit::roomPalette());
    m_whyNot->setAutoFillBackground(true);
    auto* icon = new QLabel(m_whyNot);
    icon->setPixmap(kit::linePixmap(QStringLiteral("tooth"), m_whyNot->palette().color(QPalette::PlaceholderText),
                                    kWhyNotIconPx, devicePixelRatioF()));
    icon->setAlignment(Qt::AlignCenter);
    auto* heading = new QLabel(m_whyNot);
    heading->setFont(kit::typeface(kit::kTitle, QFont::DemiBold));
    heading->setAlignment(Qt::AlignCenter);
    auto* sentence = new QLabel(m_whyNot);
    text::bindTranslation(m_whyNot, [this, heading, sentence] {
        //: Heading where a picture would be; a sentence below says why
        heading->setText(tr("No picture"));
        sentence->setText(m_sentence());
    });
    sentence->setFont(kit::typeface(kit::kBody));
    sentence->setAlignment(Qt::AlignHCenter | Qt::AlignTop);
    sentence->setWordWrap(true);
    sentence->setObjectName(QStringLiteral("whyNot"));
    // Labels created before this widget is placed in a window would keep the application's colours.
    for (QLabel* words : {heading, sentence})
        words->setPalette(kit::roomPalette());
    auto* column = new QVBoxLayout;
    column->setSpacing(kit::kSpace2);
    column->addStretch(1);
    column->addWidget(icon);
    column->addWidget(heading);
    column->addWidget(sentence);
    column->addStretch(1);
    auto* middle = new QWidget(m_whyNot);
    middle->setMaximumWidth(kWhyNotWidthPx);
    middle->setLayout(column);
    auto* row = new QHBoxLayout(m_whyNot);
    row->addStretch(1);
    row->addWidget(middle, 1000);
    row->addStretch(1);
    m_whyNot->setGeometry(rect());
    m_whyNot->show();
    setCursor(Qt::ArrowCursor);
}

}  // namespace ui::tooth
