// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <memory>

#include <glm/geometric.hpp>

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions>
#include <QTest>

#include "tests/support/SyntheticMolar.h"
#include "tests/ui/Pictures.h"
#include "ui/render/ToothRenderer.h"
#include "ui/tooth/Camera.h"

using core::terrain::ToothAnatomy;
using ui::render::Scene;
using ui::render::ToothRenderer;
using ui::render::ToothSurface;
using ui::tooth::Camera;

class TestToothRenderer : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void cleanupTestCase();
    void toothStandsInTheMiddle();
    void toothHasNoHoles();
    void materialsShowInACutByDepth();
    void cutShowsWhereItIsAndNowhereElse();
    void cutUploadsOnlyItsRectangles();
    void everyGridShowsTheSameTooth_data();
    void everyGridShowsTheSameTooth();
    void burStandsOnItsTip_data();
    void burStandsOnItsTip();
    void surfacesCanBeExchanged();
    void whatIsKeptLooksAsIfDrawnAnew();
    void aFinePictureThatIsKeptTakesTheBursLight();

private:
    QImage draw(const Scene& scene);
    [[nodiscard]] Scene scene() const;
    void show(const std::shared_ptr<const ToothAnatomy>& tooth);

    static constexpr int kWidth = 800;
    static constexpr int kHeight = 600;
    const glm::vec3 m_light = glm::normalize(glm::vec3(-0.4F, 0.4F, 0.8F));
    QOffscreenSurface m_window;
    QOpenGLContext m_context;
    std::unique_ptr<QOpenGLFramebufferObject> m_canvas;
    std::unique_ptr<ToothRenderer> m_renderer;
    std::unique_ptr<ToothSurface> m_surface;
    std::shared_ptr<const ToothAnatomy> m_tooth;
    Camera m_camera;
};

void TestToothRenderer::initTestCase()
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
    m_renderer = std::make_unique<ToothRenderer>();
    QString reason;
    QVERIFY2(m_renderer->initialize(reason), qPrintable(reason));
    m_camera.setSubject({0.0, 0.0, -3.5}, 7.4);
    m_camera.setViewport({kWidth, kHeight});
    m_tooth = support::syntheticMolar();
}

void TestToothRenderer::cleanupTestCase()
{
    m_renderer.reset();
    m_canvas.reset();
    m_context.doneCurrent();
}

Scene TestToothRenderer::scene() const
{
    Scene scene;
    scene.eyeFromTooth = m_camera.view();
    scene.clipFromEye = m_camera.projection();
    scene.eyeMm = m_camera.eyeMm();
    scene.towardsLight = m_light;
    scene.sizePx = {kWidth, kHeight};
    return scene;
}

QImage TestToothRenderer::draw(const Scene& drawn)
{
    m_canvas->bind();
    m_context.functions()->glViewport(0, 0, kWidth, kHeight);
    m_renderer->draw(drawn);
    const QImage image = m_canvas->toImage().convertToFormat(QImage::Format_RGB32);
    pictures::keep(image, QStringLiteral("renderer_") + QTest::currentTestFunction());
    return image;
}

void TestToothRenderer::show(const std::shared_ptr<const ToothAnatomy>& tooth)
{
    m_surface = std::make_unique<ToothSurface>(tooth, m_light);
    m_renderer->setSurface(*m_surface);
}

void TestToothRenderer::toothStandsInTheMiddle()
{
    const QImage room = draw(scene());
    show(m_tooth);
    m_camera.reset();
    const QImage image = draw(scene());
    const pictures::Difference tooth = pictures::difference(room, image, 20);
    const double share = static_cast<double>(tooth.pixels) / (kWidth * kHeight);
    QVERIFY2(share > 0.12 && share < 0.6, qPrintable(QString::number(share)));
    QVERIFY(tooth.box.left() > 20 && tooth.box.right() < kWidth - 20);
    QVERIFY(tooth.box.top() > 5 && tooth.box.bottom() < kHeight - 5);
    QVERIFY(std::abs(tooth.box.center().x() - kWidth / 2) < 60);
    // Ivory: light, and warmer than the room.
    const glm::dvec2 cusp = m_camera.pixelOf({-2.6, -2.6, -0.8});
    const pictures::Colour enamel = pictures::mean(image, pictures::around(cusp.x, cusp.y, 6));
    QVERIFY(enamel.brightness() > 140.0);
    QVERIFY(enamel.red > enamel.blue + 8.0);
}

void TestToothRenderer::toothHasNoHoles()
{
    show(m_tooth);
    // Seen from above a crown is one piece: in every row of pixels the tooth begins once and ends once.
    m_camera.set(0.0, 88.0, m_camera.fittingMm());
    const QImage image = draw(scene());
    int seams = 0;
    for (int y = 0; y < kHeight; ++y) {
        int changes = 0;
        bool inside = false;
        for (int x = 0; x < kWidth; ++x) {
            const QRgb pixel = image.pixel(x, y);
            // The room is dark and bluish; the tooth is light, and its decay warm.
            const bool lit = qGreen(pixel) > 90 || qRed(pixel) > qBlue(pixel) + 3;
            changes += lit != inside ? 1 : 0;
            inside = lit;
        }
        seams += changes > 2 ? 1 : 0;
    }
    // A row that only grazes the outline may break; a seam would break many.
    QVERIFY2(seams <= 4, qPrintable(QString("%1 rows are broken").arg(seams)));
    m_camera.reset();
}

void TestToothRenderer::materialsShowInACutByDepth()
{
    m_camera.set(0.0, 88.0, m_camera.fittingMm());
    // Beside the lesion: through the enamel into dentin, and over the chamber into the pulp.
    const glm::dvec2 place = pictures::tileMiddle(m_tooth->grid, {-1.6, 0.4});
    const core::terrain::ColumnLayers& column = [&]() -> const core::terrain::ColumnLayers& {
        const glm::dvec2 at = glm::round(m_tooth->grid.latticeOf(place));
        return m_tooth->layers[m_tooth->grid.index(static_cast<int>(at.x), static_cast<int>(at.y))];
    }();
    QVERIFY(column.pulpRoof > column.pulpFloor);
    const auto shown = [&](float floorMm) {
        show(m_tooth);
        m_surface->write(pictures::cutTile(*m_tooth, place, floorMm));
        m_renderer->update(*m_surface, m_surface->refresh());
        const QImage image = draw(scene());
        const glm::dvec2 pixel = m_camera.pixelOf({place, floorMm});
        return pictures::mean(image, pictures::around(pixel.x, pixel.y, 3));
    };
    const pictures::Colour enamel = shown(column.dej + 0.4F);
    const pictures::Colour dentin = shown(column.dej - 0.3F);
    const pictures::Colour pulp = shown(0.5F * (column.pulpRoof + column.pulpFloor));
    const auto yellowness = [](const pictures::Colour& c) { return (c.red + c.green) / (2.0 * c.blue + 1.0); };
    const auto redness = [](const pictures::Colour& c) { return c.red / (c.green + 1.0); };
    QVERIFY(yellowness(dentin) > 1.15 * yellowness(enamel));
    QVERIFY(redness(pulp) > 1.3 * redness(dentin));
    m_camera.reset();
}

void TestToothRenderer::cutShowsWhereItIsAndNowhereElse()
{
    show(m_tooth);
    m_camera.set(0.0, 70.0, m_camera.fittingMm());
    const QImage before = draw(scene());
    const glm::dvec2 place = pictures::tileMiddle(m_tooth->grid, {2.6, 1.2});
    m_surface->write(pictures::cutTile(*m_tooth, place, -3.4F));
    m_renderer->update(*m_surface, m_surface->refresh());
    const QImage after = draw(scene());
    const pictures::Difference cut = pictures::difference(before, after, 12);
    const glm::dvec2 pixel = m_camera.pixelOf({place, -3.0});
    QVERIFY(cut.pixels > 500);
    QVERIFY(cut.box.contains(qRound(pixel.x), qRound(pixel.y)));
    // A tile is about 1.25 mm wide; its shadow and the darker corners reach a little further.
    const double pixelsPerMm = glm::distance(m_camera.pixelOf({0, 0, -3}), m_camera.pixelOf({1, 0, -3}));
    QVERIFY2(cut.box.width() < 4.6 * pixelsPerMm, qPrintable(QString::number(cut.box.width() / pixelsPerMm)));
    QVERIFY2(cut.box.height() < 5.2 * pixelsPerMm, qPrintable(QString::number(cut.box.height() / pixelsPerMm)));
    // And nothing at all when nothing was cut.
    m_renderer->update(*m_surface, m_surface->refresh());
    QCOMPARE(pictures::difference(after, draw(scene()), 0).pixels, 0);
    m_camera.reset();
}

void TestToothRenderer::cutUploadsOnlyItsRectangles()
{
    const std::uint64_t start = m_renderer->uploadedBytes();
    show(m_tooth);
    const std::uint64_t whole = m_renderer->uploadedBytes() - start;
    m_surface->write(pictures::cutTile(*m_tooth, {2.6, 1.2}, -3.4F));
    m_renderer->update(*m_surface, m_surface->refresh());
    const std::uint64_t part = m_renderer->uploadedBytes() - start - whole;
    QVERIFY(part > 0);
    QVERIFY2(part < whole / 8, qPrintable(QString("%1 of %2 bytes").arg(part).arg(whole)));
    m_renderer->update(*m_surface, m_surface->refresh());
    QCOMPARE(m_renderer->uploadedBytes() - start - whole, part);
}

void TestToothRenderer::everyGridShowsTheSameTooth_data()
{
    QTest::addColumn<int>("side");
    QTest::newRow("64") << 64;
    QTest::newRow("301") << 301;
}

void TestToothRenderer::everyGridShowsTheSameTooth()
{
    QFETCH(int, side);
    m_camera.reset();
    show(m_tooth);
    const QImage usual = draw(scene());
    show(support::syntheticMolar(side));
    const QImage other = draw(scene());
    double sum = 0.0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            sum += std::abs(qGreen(usual.pixel(x, y)) - qGreen(other.pixel(x, y)));
    const double mean = sum / (kWidth * kHeight);
    QVERIFY2(mean < (side < 100 ? 4.0 : 2.0), qPrintable(QString("mean difference %1").arg(mean)));
}

void TestToothRenderer::burStandsOnItsTip_data()
{
    QTest::addColumn<int>("bur");
    for (std::size_t k = 0; k < core::drilling::burs().size(); ++k)
        QTest::newRow(core::drilling::burs()[k].id.data()) << static_cast<int>(k);
}

void TestToothRenderer::burStandsOnItsTip()
{
    QFETCH(int, bur);
    show(m_tooth);
    m_camera.set(15.0, 30.0, 0.7 * m_camera.fittingMm());
    Scene with = scene();
    with.tipMm = {-2.6, -2.6, m_surface->heightMm({-2.6, -2.6}) + 0.1};
    with.surfaceBelowTipMm = with.tipMm.z - 0.1;
    with.burIndex = static_cast<std::size_t>(bur);
    const QImage without = draw(scene());
    with.instrumentShown = true;
    const QImage image = draw(with);
    const core::drilling::Bur& shape = core::drilling::burs()[with.burIndex];
    const glm::dvec2 tip = m_camera.pixelOf(with.tipMm);
    // Half way up the head there is steel, as wide as the bur and not wider.
    const double height = 0.6 * shape.headLengthMm;
    const glm::dvec2 middle = m_camera.pixelOf(with.tipMm + glm::dvec3(0.0, 0.0, height));
    const glm::dvec2 right(m_camera.rightOnTooth());
    const glm::dvec2 side =
        m_camera.pixelOf(with.tipMm + glm::dvec3(right * (shape.headRadiusMm + 0.12), height)) - middle;
    const int y = qRound(middle.y);
    QVERIFY(pictures::differs(without.pixel(qRound(middle.x), y), image.pixel(qRound(middle.x), y), 15));
    QVERIFY(
        !pictures::differs(without.pixel(qRound(middle.x + side.x), y), image.pixel(qRound(middle.x + side.x), y), 40));
    QVERIFY(
        !pictures::differs(without.pixel(qRound(middle.x - side.x), y), image.pixel(qRound(middle.x - side.x), y), 40));
    // Below the tip there is at most its shadow: darker, never steel.
    for (int below = qRound(tip.y) + 12; below < kHeight; ++below)
        for (int x = 0; x < kWidth; ++x)
            QVERIFY(qGreen(image.pixel(x, below)) <= qGreen(without.pixel(x, below)) + 3);
    m_camera.reset();
}

void TestToothRenderer::surfacesCanBeExchanged()
{
    show(support::syntheticMolar(301));
    const QImage first = draw(scene());
    show(support::syntheticMolar(64));
    draw(scene());
    show(support::syntheticMolar(301));
    QCOMPARE(pictures::difference(first, draw(scene()), 0).pixels, 0);
}

/// What is kept of the pictures before must not show: all of it drawn anew looks the same, whatever has changed.
void TestToothRenderer::whatIsKeptLooksAsIfDrawnAnew()
{
    show(m_tooth);
    m_camera.set(20.0, 50.0, m_camera.fittingMm());
    Scene seen = scene();
    seen.keepsStill = true;
    seen.instrumentShown = true;
    const auto compare = [&](const char* when) {
        const QImage kept = draw(seen);
        Scene whole = seen;
        whole.keepsStill = false;
        const int differing = pictures::difference(kept, draw(whole), 2).pixels;
        QVERIFY2(differing == 0, qPrintable(QString("%1: %2 pixels").arg(when).arg(differing)));
    };
    const auto cut = [&](glm::dvec2 at, float floorMm, bool hurried) {
        m_surface->write(pictures::cutTile(*m_tooth, at, floorMm));
        m_renderer->update(*m_surface, m_surface->refresh(hurried));
    };
    compare("first");
    seen.tipMm = {1.0, 0.5, -2.0};
    compare("the bur moved");
    cut({0.0, 0.5}, -4.0F, false);
    compare("cut");
    cut({1.4, 0.5}, -3.0F, true);
    cut({1.4, 0.5}, -3.6F, true);
    compare("cut in haste");
    QVERIFY(m_surface->isBehind());
    m_renderer->update(*m_surface, m_surface->refresh());
    QVERIFY(!m_surface->isBehind());
    compare("light caught up");
    cut({-4.0, 3.0}, -20.0F, false);
    compare("cut through the flank");
    m_camera.set(-60.0, 15.0, m_camera.fittingMm());
    seen.eyeFromTooth = m_camera.view();
    seen.eyeMm = m_camera.eyeMm();
    compare("turned");
    seen.mirror = ui::render::DentalMirror{{-10.0, 4.0, 2.0}, glm::normalize(glm::dvec3(0.4, -0.8, 0.4))};
    seen.look.burLight = true;
    compare("mirror and light");
    cut({-2.0, -1.0}, -4.0F, false);
    compare("cut before the mirror");
    // Everything back: what stood there at first shows again.
    std::vector<float> whole(m_tooth->top.begin(), m_tooth->top.end());
    m_surface->write(whole);
    m_renderer->update(*m_surface, m_surface->refresh());
    compare("taken back");
    seen.look.isWet = true;
    compare("wet");
    seen.eye = 1;
    compare("the other eye");
    m_camera.reset();
}

/// A picture with smooth edges is drawn once nothing moves, and is then what the bur moves over: its shadow must fall
/// on all of it as on any other.
void TestToothRenderer::aFinePictureThatIsKeptTakesTheBursLight()
{
    show(m_tooth);
    QOpenGLFramebufferObjectFormat format;
    format.setSamples(4);
    format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
    QOpenGLFramebufferObject fine(kWidth, kHeight, format);
    m_camera.set(20.0, 50.0, m_camera.fittingMm());
    Scene seen = scene();
    seen.keepsStill = true;
    seen.instrumentShown = true;
    seen.look.burLight = true;
    seen.tipMm = {1.0, 0.5, -2.0};
    fine.bind();
    m_context.functions()->glViewport(0, 0, kWidth, kHeight);
    m_renderer->draw(seen);
    seen.tipMm.x += 0.3;
    const QImage kept = draw(seen);
    Scene whole = seen;
    whole.keepsStill = false;
    const QImage anew = draw(whole);
    // All but the edges, which are smooth in the one.
    const int differing = pictures::difference(kept, anew, 12).pixels;
    QVERIFY2(differing < kWidth * kHeight / 400, qPrintable(QString::number(differing)));
    // And so after a part of it was drawn again.
    m_surface->write(pictures::cutTile(*m_tooth, {0.0, 0.5}, -4.0F));
    m_renderer->update(*m_surface, m_surface->refresh());
    const int cut = pictures::difference(draw(seen), draw(whole), 12).pixels;
    QVERIFY2(cut < kWidth * kHeight / 400, qPrintable(QString::number(cut)));
    m_camera.reset();
}

QTEST_MAIN(TestToothRenderer)
#include "tst_tooth_renderer.moc"
