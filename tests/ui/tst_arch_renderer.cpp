// SPDX-License-Identifier: GPL-3.0-or-later
#include <glm/geometric.hpp>

#include <QTest>

#include "core/teeth/ToothBuilder.h"
#include "core/teeth/ToothTable.h"
#include "tests/support/Tables.h"
#include "tests/ui/CanvasTest.h"
#include "ui/render/ArchRenderer.h"

using core::teeth::ArchPiece;
using ui::render::ArchRenderer;
using ui::render::ArchScene;

class TestArchRenderer : public support::CanvasTest
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        makeCanvas();
        m_arches = std::make_unique<ArchRenderer>();
        QString reason;
        QVERIFY2(m_arches->initialize(reason), qPrintable(reason));
    }

    void init()
    {
        m_camera.setSubject({0.0, 24.0, -14.0}, 40.0);
        m_arches->setPieces(m_mouth);
    }

    void mouthShowsTeethAndGums()
    {
        look(0.0, 12.0);
        const QImage image = draw(mouth());
        const double enamel = pictures::count(image, [](QRgb p) { return qGreen(p) > 150 && qRed(p) - qBlue(p) < 70; });
        const double gum = pictures::count(image, [](QRgb p) { return qRed(p) > 100 && qRed(p) - qGreen(p) > 40; });
        const double all = kWidth * kHeight;
        QVERIFY2(enamel / all > 0.03, qPrintable(QString::number(enamel / all)));
        QVERIFY2(gum / all > 0.08, qPrintable(QString::number(gum / all)));
    }

    /// Seen from the front with the light at the camera, the picture is symmetric.
    void mirroredTeethAreLitFromOutside()
    {
        look(0.0, 5.0);
        const QImage image = draw(mouth());
        QVERIFY(isMirrored(image, image));
    }

    void aMirroringViewTurnsThePictureOver()
    {
        look(30.0, 10.0);
        const QImage image = draw(mouth());
        ArchScene turned = mouth();
        turned.clipFromEye = glm::dmat4(-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1) * turned.clipFromEye;
        QVERIFY(isMirrored(draw(turned), image));
    }

    void chosenAndHoveredStandOut()
    {
        look(25.0, 14.0);
        const QImage plain = draw(mouth());
        const pictures::Difference tinted = pictures::difference(plain, draw(mouth(34)), 15);
        QVERIFY(tinted.pixels > 200);
        QVERIFY(tinted.box.width() < kWidth / 6);
        ArchScene hovered = mouth();
        hovered.hoveredFdi = 34;
        const pictures::Difference lit = pictures::difference(plain, draw(hovered), 3);
        QVERIFY(lit.pixels > 200);
        QVERIFY(tinted.box.adjusted(-2, -2, 2, 2).contains(lit.box));
    }

    /// Picking agrees with drawing: if a ray meets a tooth, selecting that tooth changes the pixel, and selecting
    /// another one does not.
    void eachToothIsMetWhereItIsDrawn()
    {
        look(20.0, 10.0);
        const QImage plain = draw(mouth());
        int met = 0;
        for (const ArchPiece& piece : m_mouth) {
            if (!piece.tooth)
                continue;
            const QImage image = draw(mouth(piece.fdi));
            const double height = core::teeth::findToothSizes(core::teeth::leftFellow(piece.fdi))->crownHeightMm;
            const glm::ivec2 at(m_camera.pixelOf(glm::dvec3(piece.place * glm::dvec4(0.0, 0.0, -0.35 * height, 1.0))));
            const bool isMet = ui::render::toothMet(m_mouth, m_camera.rayThrough(glm::dvec2(at) + 0.5)) == piece.fdi;
            QCOMPARE(pictures::differs(plain.pixel(at.x, at.y), image.pixel(at.x, at.y), 6), isMet);
            met += isMet ? 1 : 0;
        }
        // The middles of the other teeth are hidden by something nearer.
        QVERIFY2(met >= 16, qPrintable(QString::number(met)));
        QCOMPARE(ui::render::toothMet(m_mouth, m_camera.rayThrough({2.0, 2.0})), 0);
    }

    void neighboursLeaveTheToothItself_data() { support::rows<int>("fdi", {21, 36}); }

    void neighboursLeaveTheToothItself()
    {
        QFETCH(int, fdi);
        const auto built = core::teeth::buildTooth({fdi}, {});
        QVERIFY(built.has_value());
        show(built->anatomy);
        m_camera.setSubject({0.0, 0.0, -3.5}, 9.0);
        // Seen straight from above, no neighbour hides the tooth.
        look(10.0, ui::tooth::Camera::kHighestDeg);
        const auto drawTooth = [&] { m_renderer->draw(scene()); };
        const QImage alone = picture(drawTooth, 0);
        m_arches->setPieces(m_arch.neighbours(fdi));
        ArchScene beside = mouth();
        beside.towardsLight = scene().towardsLight;
        const QImage with = picture(
            [&] {
                drawTooth();
                m_arches->draw(beside);
            },
            0);
        // The top of the crown is unchanged: neither gum nor a neighbour covers it.
        const core::teeth::ToothSizes sizes = *core::teeth::findToothSizes(fdi);
        int changed = 0;
        int looked = 0;
        for (int k = 0; k < 400; ++k) {
            const int line = k / 20;
            const glm::dvec2 place(0.35 * sizes.crownWidthMm * ((k % 20) / 9.5 - 1.0),
                                   0.30 * sizes.crownDepthMm * (line / 9.5 - 1.0));
            // Only the upper half, and only where there is tooth.
            if (m_surface->topMm(place).value_or(-100.0) < -0.5 * sizes.crownHeightMm)
                continue;
            ++looked;
            const glm::ivec2 pixel(m_camera.pixelOf(onTooth(place)));
            changed += alone.pixel(pixel.x, pixel.y) != with.pixel(pixel.x, pixel.y) ? 1 : 0;
        }
        QVERIFY(looked > 150);
        QVERIFY2(changed == 0, qPrintable(QString("%1 of %2 points").arg(changed).arg(looked)));
        // To the left and right there are neighbours; behind a third molar there is only gum.
        const auto gain = [&](int left) {
            const QRect third(left, 0, kWidth / 3, kHeight);
            return pictures::mean(with, third).brightness() - pictures::mean(alone, third).brightness();
        };
        QVERIFY(gain(0) > 10.0);
        QVERIFY(gain(2 * kWidth / 3) > 3.0);
    }

    void aMeshIsUploadedOnce()
    {
        const std::uint64_t once = m_arches->uploadedBytes();
        qInfo("%.1f MB", static_cast<double>(once) * 1.0e-6);
        QVERIFY(once < 9'000'000);
        m_arches->setPieces(m_arch.mouth(0.2));
        m_arches->setPieces({m_mouth.begin(), m_mouth.begin() + static_cast<std::ptrdiff_t>(m_mouth.size() / 2)});
        QCOMPARE(m_arches->uploadedBytes(), once);
    }

private:
    [[nodiscard]] ArchScene mouth(int chosenFdi = 0) const
    {
        ArchScene scene;
        scene.eyeFromScene = m_camera.view();
        scene.clipFromEye = m_camera.projection();
        scene.eyeMm = m_camera.eyeMm();
        scene.towardsLight = glm::normalize(glm::vec3(m_camera.eyeMm()) + glm::vec3(0.0F, 0.0F, 40.0F));
        scene.towardsSky = scene.towardsLight;
        scene.chosenFdi = chosenFdi;
        return scene;
    }

    QImage draw(const ArchScene& scene)
    {
        return picture(
            [&] {
                m_arches->drawRoom({kWidth, kHeight}, {0.0F, 0.0F});
                m_arches->draw(scene);
            },
            0);
    }

    static bool isMirrored(const QImage& image, const QImage& other)
    {
        const int differing = pictures::difference(image, other.mirrored(true, false), 40).pixels;
        if (differing >= kWidth * kHeight / 200)
            qWarning("%d pixels differ", differing);
        return differing < kWidth * kHeight / 200;
    }

    const core::teeth::Arch m_arch;
    const std::vector<ArchPiece> m_mouth = m_arch.mouth(0.44);
    std::unique_ptr<ArchRenderer> m_arches;
};

QTEST_MAIN(TestArchRenderer)
#include "tst_arch_renderer.moc"
