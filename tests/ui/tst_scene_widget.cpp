// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include <QBoxLayout>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QPainter>
#include <QSignalSpy>
#include <QTest>

#include "core/session/SessionChannels.h"
#include "tests/support/OpenGlMain.h"
#include "tests/support/SyntheticMolar.h"
#include "tests/ui/Pictures.h"
#include "ui/tooth/SceneWidget.h"
#include "ui/tooth/ToothView.h"

using ui::tooth::SceneWidget;
using ui::tooth::ToothView;

namespace {

const QColor kGround(40, 60, 80);
const QColor kHigh(200, 100, 50);  ///< upper quarter of the picture that OpenGL draws

/// A background whose upper quarter has another colour, with a white square painted on its upper left corner.
class Marks : public SceneWidget
{
public:
    explicit Marks(Way way, QWidget* parent = nullptr)
        : SceneWidget([] { return QStringLiteral("no OpenGL"); }, way, parent)
    {}
    ~Marks() override { leave(); }

    int prepared = 0;
    int released = 0;
    QList<int> samples;  ///< of each picture drawn
    QSize drawnPx;
    int presses = 0;
    bool refuses = false;

protected:
    bool prepareScene(QString& reason) override
    {
        ++prepared;
        reason = QStringLiteral("it would not");
        return !refuses;
    }
    void releaseScene() override
    {
        QVERIFY(QOpenGLContext::currentContext() != nullptr);
        ++released;
    }
    void drawScene(QSize sizePx, int with) override
    {
        samples.append(with);
        drawnPx = sizePx;
        QOpenGLFunctions* gl = QOpenGLContext::currentContext()->functions();
        gl->glDisable(GL_SCISSOR_TEST);
        fill(kGround);
        gl->glEnable(GL_SCISSOR_TEST);
        gl->glScissor(0, sizePx.height() - sizePx.height() / 4, sizePx.width(), sizePx.height() / 4);
        fill(kHigh);
        gl->glDisable(GL_SCISSOR_TEST);
    }
    void paintMarks(QPainter& painter) override { painter.fillRect(0, 0, 20, 20, Qt::white); }
    void mousePressEvent(QMouseEvent* /*event*/) override { ++presses; }

private:
    static void fill(const QColor& colour)
    {
        QOpenGLFunctions* gl = QOpenGLContext::currentContext()->functions();
        gl->glClearColor(static_cast<float>(colour.redF()), static_cast<float>(colour.greenF()),
                         static_cast<float>(colour.blueF()), 1.0F);
        gl->glClear(GL_COLOR_BUFFER_BIT);
    }
};

QColor at(const QImage& image, double x, double y)
{
    return image.pixelColor(qRound(x * (image.width() - 1)), qRound(y * (image.height() - 1)));
}

}  // namespace

class TestSceneWidget : public QObject
{
    Q_OBJECT

private slots:
    void bothWaysShowPictureAndMarks_data() { ways(); }

    void bothWaysShowPictureAndMarks()
    {
        QFETCH(SceneWidget::Way, way);
        Marks marks(way);
        marks.resize(320, 240);
        QSignalSpy shown(&marks, &SceneWidget::shown);
        marks.show();
        QVERIFY(QTest::qWaitForWindowExposed(&marks));
        QTRY_VERIFY(shown.count() > 0);
        QVERIFY(marks.isUsable());
        const QImage image = marks.grabPicture();
        QCOMPARE(image.size(), QSize(320, 240));
        QCOMPARE(at(image, 0.01, 0.01), QColor(Qt::white));
        QCOMPARE(at(image, 0.5, 0.1), kHigh);
        QCOMPARE(at(image, 0.5, 0.9), kGround);
        QCOMPARE(qAlpha(image.pixel(160, 200)), 255);
        shown.clear();
        marks.redraw();
        QTRY_VERIFY(shown.count() > 0);
        shown.clear();
        const auto before = marks.samples.size();
        marks.redrawNow();
        QCOMPARE(marks.samples.size(), before + 1);
    }

    void theMouseIsTheWidgetsOwn_data() { ways(); }

    void theMouseIsTheWidgetsOwn()
    {
        QFETCH(SceneWidget::Way, way);
        QWidget window;
        auto* marks = new Marks(way, &window);
        window.resize(300, 200);
        marks->resize(window.size());
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        // Sends the click to the window, as the window system does; the window finds the widget.
        QTest::mouseClick(window.windowHandle(), Qt::LeftButton, {}, QPoint(150, 100));
        QCOMPARE(marks->presses, 1);
    }

    void anotherWindowAndAnotherSizeAreDrawnAnew_data() { ways(); }

    void anotherWindowAndAnotherSizeAreDrawnAnew()
    {
        QFETCH(SceneWidget::Way, way);
        QWidget first;
        QWidget second;
        auto* marks = new Marks(way, &first);
        for (QWidget* window : {&first, &second}) {
            window->resize(300, 200);
            marks->setParent(window);
            marks->resize(window->size());
            marks->show();
            window->show();
            QVERIFY(QTest::qWaitForWindowExposed(window));
            QTRY_COMPARE(at(marks->grabPicture(), 0.5, 0.9), kGround);
            marks->resize(120, 80);
            QCOMPARE(marks->grabPicture().size(), QSize(120, 80));
            QCOMPARE(at(marks->grabPicture(), 0.5, 0.1), kHigh);
        }
        QVERIFY(marks->prepared - marks->released == 1);
    }

    void whatIsRefusedIsSaid_data() { ways(); }

    void whatIsRefusedIsSaid()
    {
        QFETCH(SceneWidget::Way, way);
        QTest::ignoreMessage(QtWarningMsg, "No picture of a tooth can be drawn: it would not.");
        Marks marks(way);
        marks.refuses = true;
        marks.resize(320, 240);
        marks.show();
        QVERIFY(QTest::qWaitForWindowExposed(&marks));
        QTRY_VERIFY(!marks.isUsable());
        marks.redrawNow();
        QVERIFY(marks.samples.isEmpty());
        QVERIFY(!marks.grabPicture().isNull());
        QCOMPARE(marks.prepared, 1);
    }

    void aSoftwareDriverSmoothesWhatRests()
    {
        Marks marks(SceneWidget::Way::Image);
        marks.resize(100, 100);
        marks.show();
        QVERIFY(QTest::qWaitForWindowExposed(&marks));
        QTRY_VERIFY(!marks.samples.isEmpty() && marks.samples.back() > 0);
        QCOMPARE(marks.samples.front(), 0);
        marks.samples.clear();
        marks.redrawNow();
        marks.redrawNow();
        QCOMPARE(marks.samples, QList<int>({0, 0}));
        QTRY_COMPARE(marks.samples.size(), 3);
        QVERIFY(marks.samples.back() > 0);
        // While the camera moves the picture has half the resolution, then the full one again.
        marks.redrawMoving();
        QTRY_COMPARE(marks.drawnPx, QSize(50, 50));
        QTRY_COMPARE(marks.drawnPx, QSize(100, 100));
        QVERIFY(marks.samples.back() > 0);
    }

    void aToothLooksTheSameOnBothWays()
    {
        core::session::UiChannels links;
        std::array<QImage, 2> images;
        for (std::size_t k = 0; k < 2; ++k) {
            ToothView view(links, nullptr, k == 0 ? SceneWidget::Way::Window : SceneWidget::Way::Image);
            view.resize(480, 360);
            view.setTooth(support::syntheticMolar(), 1);
            view.show();
            QVERIFY(QTest::qWaitForWindowExposed(&view));
            images[k] = view.picture();
        }
        QCOMPARE(images[0].size(), images[1].size());
        const int apart = pictures::difference(images[0], images[1]).pixels;
        // The letters of the gizmo and smooth edges are painted by different engines.
        QVERIFY2(apart < 480 * 360 / 100, qPrintable(QString::number(apart)));
    }

private:
    static void ways()
    {
        QTest::addColumn<SceneWidget::Way>("way");
        QTest::newRow("window") << SceneWidget::Way::Window;
        QTest::newRow("image") << SceneWidget::Way::Image;
    }
};

int main(int argc, char** argv)
{
    return support::openGlMain<TestSceneWidget>(argc, argv);
}

#include "tst_scene_widget.moc"
