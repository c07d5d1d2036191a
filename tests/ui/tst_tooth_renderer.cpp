// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <glm/geometric.hpp>

#include <QTest>

#include "core/bur/Bur.h"
#include "tests/support/SyntheticMolar.h"
#include "tests/support/Tables.h"
#include "tests/ui/CanvasTest.h"

using pictures::Colour;
using ui::render::Scene;

class TestToothRenderer : public support::CanvasTest
{
    Q_OBJECT

private slots:
    void initTestCase() { makeCanvas(); }

    void toothStandsInTheMiddle()
    {
        const QImage room = draw(scene());
        show(support::syntheticMolar());
        const QImage image = draw(scene());
        const pictures::Difference tooth = pictures::difference(room, image, 20);
        const double share = static_cast<double>(tooth.pixels) / (kWidth * kHeight);
        QVERIFY2(share > 0.12 && share < 0.6, qPrintable(QString::number(share)));
        QVERIFY(tooth.box.left() > 20 && tooth.box.right() < kWidth - 20);
        QVERIFY(tooth.box.top() > 5 && tooth.box.bottom() < kHeight - 5);
        QVERIFY(std::abs(tooth.box.center().x() - kWidth / 2) < 60);
        // Ivory: bright, and warmer than the background.
        const Colour enamel = at(image, {-2.6, -2.6, -0.8}, 6);
        QVERIFY(enamel.brightness() > 140.0);
        QVERIFY(enamel.red > enamel.blue + 8.0);
    }

    /// From above, a crown has no holes: each row of pixels has one connected run of the tooth.
    void toothHasNoHoles()
    {
        show(support::syntheticMolar());
        look(0.0, 88.0);
        const QImage image = draw(scene());
        int seams = 0;
        for (int y = 0; y < kHeight; ++y) {
            int changes = 0;
            bool inside = false;
            for (int x = 0; x < kWidth; ++x) {
                const QRgb pixel = image.pixel(x, y);
                // The background is dark and bluish; the tooth is bright, and its decay warm.
                const bool lit = qGreen(pixel) > 90 || qRed(pixel) > qBlue(pixel) + 3;
                changes += lit != inside ? 1 : 0;
                inside = lit;
            }
            seams += changes > 2 ? 1 : 0;
        }
        // A row that only touches the outline may be interrupted; a seam would interrupt many rows.
        QVERIFY2(seams <= 4, qPrintable(QString("%1 rows are broken").arg(seams)));
    }

    /// One cut beside the lesion reaches dentin, and one above the pulp chamber reaches the pulp.
    void materialsShowInACutByDepth()
    {
        show(support::syntheticMolar());
        look(0.0, 88.0);
        const glm::dvec2 place = pictures::tileMiddle(m_surface->anatomy().grid, {-1.6, 0.4});
        const core::terrain::ColumnLayers column = m_surface->anatomy().layers[nodeAt(place)];
        QVERIFY(column.pulpRoof > column.pulpFloor);
        const auto shown = [&](float floorMm) {
            cut(place, floorMm);
            return at(draw(scene()), {place, floorMm});
        };
        const Colour enamel = shown(column.dej + 0.4F);
        const Colour dentin = shown(column.dej - 0.3F);
        const Colour pulp = shown(0.5F * (column.pulpRoof + column.pulpFloor));
        const auto yellowness = [](const Colour& c) { return (c.red + c.green) / (2.0 * c.blue + 1.0); };
        const auto redness = [](const Colour& c) { return c.red / (c.green + 1.0); };
        QVERIFY(yellowness(dentin) > 1.15 * yellowness(enamel));
        QVERIFY(redness(pulp) > 1.3 * redness(dentin));
    }

    void cutShowsWhereItIsAndNowhereElse()
    {
        show(support::syntheticMolar());
        look(0.0, 70.0);
        const QImage before = draw(scene());
        const glm::dvec2 place = pictures::tileMiddle(m_surface->anatomy().grid, {2.6, 1.2});
        cut(place, -3.4F);
        const QImage after = draw(scene());
        const pictures::Difference cut = pictures::difference(before, after, 12);
        const glm::dvec2 pixel = m_camera.pixelOf({place, -3.0});
        QVERIFY(cut.pixels > 500);
        QVERIFY(cut.box.contains(qRound(pixel.x), qRound(pixel.y)));
        // A tile is about 1.25 mm wide. Its shadow and the darker corners extend slightly further.
        const double pixelsPerMm = glm::distance(m_camera.pixelOf({0, 0, -3}), m_camera.pixelOf({1, 0, -3}));
        QVERIFY2(cut.box.width() < 4.6 * pixelsPerMm, qPrintable(QString::number(cut.box.width() / pixelsPerMm)));
        QVERIFY2(cut.box.height() < 5.2 * pixelsPerMm, qPrintable(QString::number(cut.box.height() / pixelsPerMm)));
        update();
        QCOMPARE(pictures::difference(after, draw(scene()), 0).pixels, 0);
    }

    void cutUploadsOnlyItsRectangles()
    {
        const std::uint64_t start = m_renderer->uploadedBytes();
        show(support::syntheticMolar());
        const std::uint64_t whole = m_renderer->uploadedBytes() - start;
        cut({2.6, 1.2}, -3.4F);
        const std::uint64_t part = m_renderer->uploadedBytes() - start - whole;
        QVERIFY(part > 0);
        QVERIFY2(part < whole / 8, qPrintable(QString("%1 of %2 bytes").arg(part).arg(whole)));
        update();
        QCOMPARE(m_renderer->uploadedBytes() - start - whole, part);
    }

    void everyGridShowsTheSameTooth_data() { support::rows<int>("side", {64, 301}); }

    void everyGridShowsTheSameTooth()
    {
        QFETCH(int, side);
        show(support::syntheticMolar());
        const ui::tooth::Camera camera = m_camera;
        const QImage usual = draw(scene());
        show(support::syntheticMolar(side));
        m_camera = camera;
        const QImage other = draw(scene());
        double sum = 0.0;
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x)
                sum += std::abs(qGreen(usual.pixel(x, y)) - qGreen(other.pixel(x, y)));
        const double mean = sum / (kWidth * kHeight);
        QVERIFY2(mean < (side < 100 ? 4.0 : 2.0), qPrintable(QString("mean difference %1").arg(mean)));
    }

    void burStandsOnItsTip_data()
    {
        QTest::addColumn<std::size_t>("bur");
        for (std::size_t k = 0; k < core::bur::burs().size(); ++k)
            QTest::newRow(core::bur::burs()[k].id.data()) << k;
    }

    void burStandsOnItsTip()
    {
        QFETCH(std::size_t, bur);
        show(support::syntheticMolar());
        look(15.0, 30.0, 0.7);
        Scene with = scene();
        with.tipMm = onTooth({-2.6, -2.6});
        with.surfaceBelowTipMm = with.tipMm.z;
        with.tipMm.z += 0.1;
        with.burIndex = bur;
        const QImage without = draw(scene());
        with.instrumentShown = true;
        const QImage image = draw(with);
        const core::bur::Bur& shape = core::bur::burs()[bur];
        // Half-way up the head, or where it leaves the picture, there is steel as wide as the bur and no wider.
        const glm::dvec3 middle = with.tipMm + glm::dvec3(0.0, 0.0, std::min(0.6 * shape.headLengthMm, 2.5));
        const glm::dvec3 beside((shape.headRadiusMm + 0.12) * m_camera.rightOnTooth(), 0.0);
        const auto changes = [&](glm::dvec3 pointMm, int threshold) {
            const glm::ivec2 pixel(glm::round(m_camera.pixelOf(pointMm)));
            return pictures::differs(without.pixel(pixel.x, pixel.y), image.pixel(pixel.x, pixel.y), threshold);
        };
        QVERIFY(changes(middle, 15));
        QVERIFY(!changes(middle + beside, 40));
        QVERIFY(!changes(middle - beside, 40));
        // Below the tip there is at most its shadow: darker, never steel.
        for (int below = qRound(m_camera.pixelOf(with.tipMm).y) + 12; below < kHeight; ++below)
            for (int x = 0; x < kWidth; ++x)
                QVERIFY(qGreen(image.pixel(x, below)) <= qGreen(without.pixel(x, below)) + 3);
    }

    void handpieceHidesNothingAboutTheTip_data()
    {
        QTest::addColumn<double>("elevationDeg");
        for (const double elevationDeg : {30.0, 48.0, 65.0, 88.0})
            QTest::addRow("from %.0f degrees", elevationDeg) << elevationDeg;
    }

    /// Seen from any elevation, the tooth around the tip is visible; only bur and shank cover part of it.
    void handpieceHidesNothingAboutTheTip()
    {
        QFETCH(double, elevationDeg);
        show(support::syntheticMolar());
        look(15.0, elevationDeg);
        Scene with = scene();
        with.tipMm = onTooth({0.0, 0.5});
        const QImage without = draw(scene());
        with.instrumentShown = true;
        const QImage image = draw(with);
        int covered = 0;
        int all = 0;
        for (int degrees = 0; degrees < 360; degrees += 10) {
            const double angle = glm::radians(1.0 * degrees);
            const glm::ivec2 pixel(glm::round(
                m_camera.pixelOf(onTooth(glm::dvec2(0.0, 0.5) + 1.5 * glm::dvec2(std::cos(angle), std::sin(angle))))));
            ++all;
            // A shadow darkens the pixel; metal, which is bluish, changes its colour.
            const QColor before(without.pixel(pixel.x, pixel.y));
            const QColor after(image.pixel(pixel.x, pixel.y));
            if (after.blue() - after.red() > before.blue() - before.red() + 25 ||
                after.lightness() > before.lightness() + 8)
                ++covered;
        }
        QVERIFY2(covered * 3 < all, qPrintable(QStringLiteral("%1 of %2").arg(covered).arg(all)));
    }

    void surfacesCanBeExchanged()
    {
        show(support::syntheticMolar(301));
        const QImage first = draw(scene());
        show(support::syntheticMolar(64));
        draw(scene());
        show(support::syntheticMolar(301));
        QCOMPARE(pictures::difference(first, draw(scene()), 0).pixels, 0);
    }

    /// A picture composed from cached parts must look as if drawn from scratch, whatever has changed.
    void whatIsKeptLooksAsIfDrawnAnew()
    {
        show(support::syntheticMolar());
        look(20.0, 50.0);
        Scene seen = keptScene();
        const auto compare = [&](const char* when) {
            const QImage kept = draw(seen);
            const int differing = pictures::difference(kept, drawAnew(seen), 2).pixels;
            QVERIFY2(differing == 0, qPrintable(QString("%1: %2 pixels").arg(when).arg(differing)));
        };
        compare("first");
        seen.tipMm = {1.0, 0.5, -2.0};
        compare("the bur moved");
        cut({0.0, 0.5}, -4.0F);
        compare("cut");
        cut({1.4, 0.5}, -3.0F, true);
        cut({1.4, 0.5}, -3.6F, true);
        compare("cut in haste");
        QVERIFY(m_surface->isBehind());
        update();
        QVERIFY(!m_surface->isBehind());
        compare("light caught up");
        cut({-4.0, 3.0}, -20.0F);
        compare("cut through the flank");
        look(-60.0, 15.0);
        seen.eyeFromTooth = m_camera.view();
        seen.eyeMm = m_camera.eyeMm();
        compare("turned");
        seen.mirror = ui::render::DentalMirror{{-10.0, 4.0, 2.0}, glm::normalize(glm::dvec3(0.4, -0.8, 0.4))};
        seen.look.burLight = true;
        compare("mirror and light");
        cut({-2.0, -1.0}, -4.0F);
        compare("cut before the mirror");
        m_surface->write(m_surface->anatomy().top);
        update();
        compare("taken back");
        seen.look.isWet = true;
        compare("wet");
        seen.eye = 1;
        compare("the other eye");
    }

    /// When nothing moves, a picture with smooth edges is drawn and cached. When the bur then moves over it, the bur's
    /// light and shadow must fall on it as on any other picture.
    void aFinePictureThatIsKeptTakesTheBursLight()
    {
        show(support::syntheticMolar());
        look(20.0, 50.0);
        Scene seen = keptScene();
        seen.look.burLight = true;
        seen.tipMm = {1.0, 0.5, -2.0};
        draw(seen, ui::render::Canvas::kSamples);
        seen.tipMm.x += 0.3;
        const auto edges = [&] {
            const QImage kept = draw(seen);
            return pictures::difference(kept, drawAnew(seen), 12).pixels;
        };
        // All pixels are equal except at the edges, which are smooth in one of the pictures.
        QVERIFY(edges() < kWidth * kHeight / 400);
        // The same holds after part of it was drawn again.
        cut({0.0, 0.5}, -4.0F);
        QVERIFY(edges() < kWidth * kHeight / 400);
    }

private:
    QImage draw(const Scene& scene, int samples = 0)
    {
        return picture([&] { m_renderer->draw(scene); }, samples);
    }

    QImage drawAnew(Scene scene)
    {
        scene.keepsStill = false;
        return draw(scene);
    }

    [[nodiscard]] Scene keptScene() const
    {
        Scene seen = scene();
        seen.keepsStill = true;
        seen.instrumentShown = true;
        return seen;
    }
};

QTEST_MAIN(TestToothRenderer)
#include "tst_tooth_renderer.moc"
