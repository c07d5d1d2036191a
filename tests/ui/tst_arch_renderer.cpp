// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include <glm/geometric.hpp>

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions>
#include <QTest>

#include "core/teeth/ToothBuilder.h"
#include "core/teeth/ToothTable.h"
#include "tests/ui/Pictures.h"
#include "ui/render/ArchRenderer.h"
#include "ui/render/ToothRenderer.h"
#include "ui/tooth/Camera.h"

using core::teeth::ArchPiece;
using ui::render::ArchRenderer;
using ui::render::ArchScene;
using ui::tooth::Camera;

class TestArchRenderer : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void cleanupTestCase();
    void mouthShowsTeethAndGums();
    void mirroredTeethAreLitFromOutside();
    void aMirroringViewTurnsThePictureOver();
    void chosenAndHoveredStandOut();
    void eachToothIsMetWhereItIsDrawn();
    void neighboursLeaveTheToothItself_data();
    void neighboursLeaveTheToothItself();
    void aMeshIsUploadedOnce();

private:
    [[nodiscard]] ArchScene scene() const;
    QImage draw(const ArchScene& scene);
    void keep(const QImage& image) const;

    static constexpr int kWidth = 960;
    static constexpr int kHeight = 720;
    const core::teeth::Arch m_arch;
    QOffscreenSurface m_window;
    QOpenGLContext m_context;
    std::unique_ptr<QOpenGLFramebufferObject> m_canvas;
    std::unique_ptr<ArchRenderer> m_renderer;
    Camera m_camera;
};

void TestArchRenderer::initTestCase()
{
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    m_context.setFormat(format);
    QVERIFY2(m_context.create(), "this display offers no OpenGL 3.3 core");
    m_window.setFormat(m_context.format());
    m_window.create();
    QVERIFY(m_context.makeCurrent(&m_window));
    m_canvas =
        std::make_unique<QOpenGLFramebufferObject>(kWidth, kHeight, QOpenGLFramebufferObject::CombinedDepthStencil);
    m_renderer = std::make_unique<ArchRenderer>();
    QString reason;
    QVERIFY2(m_renderer->initialize(reason), qPrintable(reason));
    m_camera.setSubject({0.0, 24.0, -14.0}, 40.0);
    m_camera.setViewport({kWidth, kHeight});
}

void TestArchRenderer::cleanupTestCase()
{
    m_renderer.reset();
    m_canvas.reset();
    m_context.doneCurrent();
}

ArchScene TestArchRenderer::scene() const
{
    ArchScene scene;
    scene.eyeFromScene = m_camera.view();
    scene.clipFromEye = m_camera.projection();
    scene.eyeMm = m_camera.eyeMm();
    scene.towardsLight = glm::normalize(glm::vec3(m_camera.eyeMm()) + glm::vec3(0.0F, 0.0F, 40.0F));
    scene.towardsSky = scene.towardsLight;
    return scene;
}

void TestArchRenderer::keep(const QImage& image) const
{
    QString name = QStringLiteral("arch_") + QTest::currentTestFunction();
    if (QTest::currentDataTag() != nullptr)
        name += '_' + QString(QTest::currentDataTag());
    pictures::keep(image, name);
}

QImage TestArchRenderer::draw(const ArchScene& drawn)
{
    m_canvas->bind();
    m_context.functions()->glViewport(0, 0, kWidth, kHeight);
    m_renderer->drawRoom({kWidth, kHeight}, {0.0F, 0.0F});
    m_renderer->draw(drawn);
    const QImage image = m_canvas->toImage().convertToFormat(QImage::Format_RGB32);
    keep(image);
    return image;
}

void TestArchRenderer::mouthShowsTeethAndGums()
{
    m_renderer->setPieces(m_arch.mouth(0.44));
    m_camera.set(0.0, 12.0, m_camera.fittingMm());
    const QImage image = draw(scene());
    int enamel = 0;
    int gum = 0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const QRgb p = image.pixel(x, y);
            enamel += qGreen(p) > 150 && qRed(p) - qBlue(p) < 70 ? 1 : 0;
            gum += qRed(p) > 100 && qRed(p) - qGreen(p) > 40 ? 1 : 0;
        }
    }
    const double all = kWidth * kHeight;
    QVERIFY2(enamel / all > 0.03, qPrintable(QString::number(enamel / all)));
    QVERIFY2(gum / all > 0.08, qPrintable(QString::number(gum / all)));
}

void TestArchRenderer::mirroredTeethAreLitFromOutside()
{
    // Seen straight on, with the light from the eye, the picture is its own mirror image.
    m_renderer->setPieces(m_arch.mouth(0.44));
    m_camera.set(0.0, 5.0, m_camera.fittingMm());
    const QImage image = draw(scene());
    const pictures::Difference difference = pictures::difference(image, image.mirrored(true, false), 40);
    QVERIFY2(difference.pixels < kWidth * kHeight / 200, qPrintable(QString::number(difference.pixels)));
}

void TestArchRenderer::aMirroringViewTurnsThePictureOver()
{
    m_renderer->setPieces(m_arch.mouth(0.44));
    m_camera.set(30.0, 10.0, m_camera.fittingMm());
    const QImage image = draw(scene());
    ArchScene turned = scene();
    turned.clipFromEye = glm::dmat4(-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1) * turned.clipFromEye;
    const pictures::Difference difference = pictures::difference(draw(turned), image.mirrored(true, false), 40);
    QVERIFY2(difference.pixels < kWidth * kHeight / 200, qPrintable(QString::number(difference.pixels)));
}

void TestArchRenderer::chosenAndHoveredStandOut()
{
    m_renderer->setPieces(m_arch.mouth(0.44));
    m_camera.set(25.0, 14.0, m_camera.fittingMm());
    const QImage plain = draw(scene());
    ArchScene chosen = scene();
    chosen.chosenFdi = 34;
    const pictures::Difference tinted = pictures::difference(plain, draw(chosen), 15);
    QVERIFY(tinted.pixels > 200);
    QVERIFY(tinted.box.width() < kWidth / 6);
    ArchScene hovered = scene();
    hovered.hoveredFdi = 34;
    const pictures::Difference lit = pictures::difference(plain, draw(hovered), 3);
    QVERIFY(lit.pixels > 200);
    QVERIFY(tinted.box.adjusted(-2, -2, 2, 2).contains(lit.box));
}

/// Picking and drawing agree: where a ray meets a tooth, choosing it changes that pixel and no other tooth does.
void TestArchRenderer::eachToothIsMetWhereItIsDrawn()
{
    const std::vector<ArchPiece> pieces = m_arch.mouth(0.44);
    m_renderer->setPieces(pieces);
    m_camera.set(20.0, 10.0, m_camera.fittingMm());
    const QImage plain = draw(scene());
    int met = 0;
    for (const ArchPiece& piece : pieces) {
        if (!piece.tooth)
            continue;
        ArchScene chosen = scene();
        chosen.chosenFdi = piece.fdi;
        const QImage image = draw(chosen);
        const double height = core::teeth::findToothSizes(core::teeth::leftFellow(piece.fdi))->crownHeightMm;
        const glm::dvec2 at = m_camera.pixelOf(glm::dvec3(piece.place * glm::dvec4(0.0, 0.0, -0.35 * height, 1.0)));
        const int x = static_cast<int>(at.x);
        const int y = static_cast<int>(at.y);
        const int fdi = ui::render::toothMet(pieces, m_camera.rayThrough({x + 0.5, y + 0.5}));
        QCOMPARE(pictures::differs(plain.pixel(x, y), image.pixel(x, y), 6), fdi == piece.fdi);
        met += fdi == piece.fdi ? 1 : 0;
    }
    // Of the others something nearer hides the middle.
    QVERIFY2(met >= 16, qPrintable(QString::number(met)));
    QCOMPARE(ui::render::toothMet(pieces, m_camera.rayThrough({2.0, 2.0})), 0);
}

void TestArchRenderer::neighboursLeaveTheToothItself_data()
{
    QTest::addColumn<int>("fdi");
    for (const int fdi : {21, 36})
        QTest::addRow("%d", fdi) << fdi;
}

void TestArchRenderer::neighboursLeaveTheToothItself()
{
    QFETCH(int, fdi);
    auto built = core::teeth::buildTooth({fdi}, {});
    QVERIFY(built.has_value());
    const glm::vec3 light = glm::normalize(glm::vec3(-0.45F, 0.22F, 0.87F));
    ui::render::ToothSurface surface(built->anatomy, light);
    ui::render::ToothRenderer tooth;
    QString reason;
    QVERIFY2(tooth.initialize(reason), qPrintable(reason));
    tooth.setSurface(surface);
    Camera camera;
    camera.setViewport({kWidth, kHeight});
    camera.setSubject({0.0, 0.0, -3.5}, 9.0);
    // From straight above: no neighbour stands before the tooth.
    camera.set(10.0, Camera::kHighestDeg, camera.fittingMm());
    ui::render::Scene single;
    single.eyeFromTooth = camera.view();
    single.clipFromEye = camera.projection();
    single.eyeMm = camera.eyeMm();
    single.towardsLight = light;
    single.sizePx = {kWidth, kHeight};
    m_canvas->bind();
    m_context.functions()->glViewport(0, 0, kWidth, kHeight);
    tooth.draw(single);
    const QImage alone = m_canvas->toImage().convertToFormat(QImage::Format_RGB32);

    m_renderer->setPieces(m_arch.neighbours(fdi));
    ArchScene beside;
    beside.eyeFromScene = camera.view();
    beside.clipFromEye = camera.projection();
    beside.eyeMm = camera.eyeMm();
    beside.towardsLight = light;
    m_canvas->bind();
    m_renderer->draw(beside);
    const QImage with = m_canvas->toImage().convertToFormat(QImage::Format_RGB32);
    keep(with);

    // The crown's upper side is as it was: neither gum nor neighbour covers it.
    const core::teeth::ToothSizes sizes = *core::teeth::findToothSizes(fdi);
    int changed = 0;
    int looked = 0;
    for (int k = 0; k < 400; ++k) {
        const double x = 0.35 * sizes.crownWidthMm * ((k % 20) / 9.5 - 1.0);
        const int line = k / 20;
        const double y = 0.30 * sizes.crownDepthMm * (line / 9.5 - 1.0);
        // Its upper half, and where there is a tooth at all.
        if (surface.topMm({x, y}).value_or(-100.0) < -0.5 * sizes.crownHeightMm)
            continue;
        ++looked;
        const glm::dvec2 at = camera.pixelOf({x, y, surface.heightMm({x, y})});
        const int column = static_cast<int>(at.x);
        const int row = static_cast<int>(at.y);
        changed += pictures::differs(alone.pixel(column, row), with.pixel(column, row), 0) ? 1 : 0;
    }
    QVERIFY(looked > 150);
    QVERIFY2(changed == 0, qPrintable(QString("%1 of %2 points").arg(changed).arg(looked)));
    // To the left and right something new stands; behind a third molar there is gum alone.
    const QRect left(0, 0, kWidth / 3, kHeight);
    const QRect right(2 * kWidth / 3, 0, kWidth / 3, kHeight);
    QVERIFY(pictures::mean(with, left).brightness() > pictures::mean(alone, left).brightness() + 10.0);
    QVERIFY(pictures::mean(with, right).brightness() > pictures::mean(alone, right).brightness() + 3.0);
}

void TestArchRenderer::aMeshIsUploadedOnce()
{
    ArchRenderer renderer;
    QString reason;
    QVERIFY2(renderer.initialize(reason), qPrintable(reason));
    std::vector<ArchPiece> pieces = m_arch.mouth(0.2);
    renderer.setPieces(pieces);
    const std::uint64_t once = renderer.uploadedBytes();
    qInfo("%.1f MB", static_cast<double>(once) * 1.0e-6);
    QVERIFY(once < 8'000'000);
    renderer.setPieces(m_arch.mouth(0.4));
    pieces.resize(pieces.size() / 2);
    renderer.setPieces(pieces);
    QCOMPARE(renderer.uploadedBytes(), once);
}

QTEST_MAIN(TestArchRenderer)
#include "tst_arch_renderer.moc"
