// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include <QGuiApplication>
#include <QTest>

#include "tests/support/SyntheticMolar.h"
#include "tests/ui/CanvasTest.h"
#include "ui/render/Presenter.h"

using pictures::Colour;
using ui::render::DentalMirror;
using ui::render::Presentation;
using ui::render::Presenter;
using ui::render::Scene;
using ui::render::Stereo;

/// Ways to draw a tooth: mirror, palettes, lights, stereo, flipped.
class TestPresenter : public support::CanvasTest
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        makeCanvas();
        m_presenter = std::make_unique<Presenter>();
        QString reason;
        QVERIFY2(m_presenter->initialize(reason), qPrintable(reason));
    }

    void init() { show(support::syntheticMolar()); }

    /// The dark lesion is easy to recognize. It must appear in a mirror above the tooth.
    void theMirrorShowsThePointWhereItsImageStands()
    {
        const glm::dvec3 lesion = onTooth(kLesion);
        look(0.0, 12.0);
        Scene seen = scene();
        const QImage without = draw(seen);
        DentalMirror mirror;
        mirror.centreMm = lesion + glm::dvec3(0.0, 5.0, 7.0);
        const glm::dvec3 towardsEye = glm::normalize(seen.eyeMm - mirror.centreMm);
        mirror.normal = glm::normalize(towardsEye + glm::normalize(lesion - mirror.centreMm));
        seen.mirror = mirror;
        const QImage with = draw(seen);
        const glm::dvec3 image = mirror.image(lesion);
        const double beside = at(with, mirror.image(lesion + glm::dvec3(-2.4, 0.0, 0.3))).brightness();
        const double dark = at(with, image).brightness();
        QVERIFY2(dark < 0.6 * beside, qPrintable(QStringLiteral("%1 %2").arg(dark).arg(beside)));
        QVERIFY(beside > 100.0);
        // The background was at the place of the mirror.
        QVERIFY(at(without, image).brightness() < 80.0);
        // The tooth itself is unchanged.
        const glm::dvec3 flank(0.0, -4.5, -5.0);
        QVERIFY(std::abs(at(with, flank).brightness() - at(without, flank).brightness()) < 2.0);
    }

    void depthColoursMarkTheCutAlone()
    {
        look(0.0, 88.0);
        const glm::dvec2 place = pictures::tileMiddle(m_surface->lattice(), {2.6, 1.2});
        const double whole = m_surface->heightMm(place);
        Scene seen = scene();
        seen.look.depthColours = ui::render::DepthColours::BelowOriginal;
        cut(place, static_cast<float>(whole - 0.4));
        QVERIFY(std::abs(m_surface->belowUncutMm({place, whole - 0.4}) - 0.4) < 0.05);
        const Colour shallow = at(draw(seen), {place, whole - 0.4});
        QVERIFY(shallow.blue > 1.2 * shallow.red);
        cut(place, static_cast<float>(whole - 2.8));
        const QImage deep = draw(seen);
        const Colour floor = at(deep, {place, whole - 2.8});
        QVERIFY(floor.red > 1.3 * floor.blue);
        const glm::dvec3 away = onTooth({-2.0, 1.8});
        QVERIFY(isGrey(at(deep, away)));
        QVERIFY(std::abs(m_surface->belowUncutMm(away)) < 1e-5);
    }

    void idealColoursTellWhatIsToGoAndWhatIsTooDeep()
    {
        // The blood of an opened pulp would cover the colours.
        const auto withoutPulp = std::make_shared<core::terrain::ToothAnatomy>(*support::syntheticMolar());
        for (core::terrain::ColumnLayers& column : withoutPulp->layers)
            column.pulpRoof = column.pulpFloor;
        show(withoutPulp);
        look(0.0, 88.0);
        const auto ideal = core::grading::idealCavity(m_surface->anatomy());
        QVERIFY(ideal != nullptr);
        m_surface->setIdeal(ideal);
        m_renderer->setSurface(*m_surface);
        Scene seen = scene();
        seen.look.depthColours = ui::render::DepthColours::AgainstIdeal;
        const float floor = (*ideal)[nodeAt(kLesion)];
        const double whole = m_surface->heightMm(kLesion);
        QVERIFY(whole - static_cast<double>(floor) > 0.8);
        const Colour toGo = at(draw(seen), {kLesion, whole});
        QVERIFY2(toGo.blue > 1.3 * toGo.red, qPrintable(QString("%1 %2").arg(toGo.red).arg(toGo.blue)));
        cut(kLesion, floor);
        QVERIFY(isGrey(at(draw(seen), {kLesion, floor}), 25.0));
        cut(kLesion, floor - 1.0F);
        const QImage deep = draw(seen);
        const Colour tooDeep = at(deep, {kLesion, floor - 1.0F});
        QVERIFY(tooDeep.red > 1.3 * tooDeep.blue);
        QVERIFY(isGrey(at(deep, onTooth({-2.6, 1.8}))));
    }

    void everyTissueHasItsOwnColourAndPattern()
    {
        look(0.0, 88.0, 0.6);
        const glm::dvec2 place = pictures::tileMiddle(m_surface->lattice(), {-1.6, 0.4});
        const core::terrain::ColumnLayers& column = m_surface->anatomy().layers.at(nodeAt(place));
        Scene seen = scene();
        seen.look.palette = ui::render::Palette::Distinct;
        const QImage whole = draw(seen);
        const Colour enamel = at(whole, onTooth({-2.0, 1.8}));
        QVERIFY(enamel.red > 1.3 * enamel.blue);  // yellow, and plain
        const Colour decay = at(whole, onTooth(kLesion));
        QVERIFY(decay.blue > 1.3 * decay.red);
        Colour colour;
        const auto cutInto = [&](float heightMm) {
            cut(place, heightMm);
            const QImage image = draw(seen);
            colour = at(image, {place, heightMm}, 12);
            const glm::dvec2 pixel = m_camera.pixelOf({place, heightMm});
            const QImage patch = image.copy(pictures::around(pixel.x, pixel.y, 14));
            int darkest = 255;
            int lightest = 0;
            for (int y = 0; y < patch.height(); ++y) {
                for (int x = 0; x < patch.width(); ++x) {
                    darkest = std::min(darkest, qGray(patch.pixel(x, y)));
                    lightest = std::max(lightest, qGray(patch.pixel(x, y)));
                }
            }
            QVERIFY2(lightest - darkest > 12, qPrintable(QString("no pattern at %1 mm").arg(heightMm)));
        };
        cutInto(column.dej - 0.3F);
        QVERIFY(colour.red > 1.8 * colour.blue);
        cutInto(0.5F * (column.pulpRoof + column.pulpFloor));
        QVERIFY(colour.blue > 1.1 * colour.green);  // purple
    }

    void theHandpiecesLightReachesTheWorkAndNotTheShadow()
    {
        const glm::dvec2 place = pictures::tileMiddle(m_surface->lattice(), {0.0, 0.5});
        const auto floor = static_cast<float>(m_surface->heightMm(place) - 2.0);
        cut(place, floor);
        look(0.0, 80.0);
        Scene seen = scene();
        seen.instrumentShown = true;
        seen.tipMm = {place, 1.5};
        seen.handAzimuthRad = 0.0;
        const QImage dark = draw(seen);
        seen.look.burLight = true;
        const QImage lit = draw(seen);
        const auto gain = [&](glm::dvec3 point) {
            return at(lit, point, 2).brightness() - at(dark, point, 2).brightness();
        };
        // The lamp is on the side of the handle: it lights the far side of the floor, but not the part under the near
        // wall.
        const double open = gain({place + glm::dvec2(-0.35, 0.0), floor});
        QVERIFY2(open > 8.0, qPrintable(QString::number(open)));
        const double aside = gain(onTooth({-4.2, -2.5}));
        QVERIFY2(aside < open, qPrintable(QString::number(aside)));
    }

    void aWetToothShines()
    {
        Scene seen = scene();
        const auto shining = [&] { return pictures::count(draw(seen), [](QRgb p) { return qGray(p) > 240; }); };
        cut(pictures::tileMiddle(m_surface->lattice(), {2.6, 1.2}), -3.0F);
        const int dry = shining();
        seen.look.isWet = true;
        const int wet = shining();
        QVERIFY2(wet > dry, qPrintable(QStringLiteral("%1 %2").arg(wet).arg(dry)));
    }

    void theGhostIsFaint()
    {
        Scene seen = scene();
        seen.instrumentShown = true;
        seen.burIndex = 3;
        seen.tipMm = {0.0, 0.0, 1.0};
        const QImage without = draw(seen);
        seen.ghostMm = glm::dvec3(0.0, 0.0, -2.0);
        const QImage with = draw(seen);
        const pictures::Difference ghost = pictures::difference(without, with, 4);
        QVERIFY(ghost.pixels > 100);
        // It is translucent.
        QVERIFY(pictures::difference(without, with, 120).pixels < ghost.pixels / 10);
        const glm::dvec2 tip = m_camera.pixelOf({0.0, 0.0, -1.0});
        QVERIFY(ghost.box.contains(qRound(tip.x), qRound(tip.y)));
    }

    void whatLiesInTheScreenIsSeenAlikeByBothEyes()
    {
        const Scene seen = scene();
        Presentation how;
        how.stereo = Stereo::RedCyan;
        const double focus = m_camera.distanceMm();
        const Scene left = Presenter::seenBy(-1, seen, how, focus);
        const Scene right = Presenter::seenBy(1, seen, how, focus);
        // Returns how far right of its position for the right eye the left eye sees a point.
        const auto crossed = [&](double share) {
            const glm::dvec4 point = glm::inverse(seen.eyeFromTooth) * glm::dvec4(1.3, 0.7, -share * focus, 1.0);
            const auto across = [&](const Scene& one) {
                const glm::dvec4 clip = one.clipFromEye * one.eyeFromTooth * point;
                return clip.x / clip.w;
            };
            return across(left) - across(right);
        };
        QVERIFY(std::abs(crossed(1.0)) < 1.0e-9);
        QVERIFY(crossed(0.8) > 1.0e-3);   // in front of the screen
        QVERIFY(crossed(1.2) < -1.0e-3);  // behind it
        QVERIFY(std::abs(glm::distance(left.eyeMm, right.eyeMm) - how.apart * focus) < 1.0e-9);
    }

    void glassesGiveEachEyeItsPicture()
    {
        Presentation how;
        how.stereo = Stereo::RedCyanGrey;
        const QImage both = draw(scene(), how);
        const QImage left = drawFor(-1, how);
        const QImage right = drawFor(1, how);
        const auto grey = [](QRgb p) { return 0.299 * qRed(p) + 0.587 * qGreen(p) + 0.114 * qBlue(p); };
        int wrong = 0;
        for (int y = 0; y < kHeight; y += 3) {
            for (int x = 0; x < kWidth; x += 3) {
                wrong += std::abs(qRed(both.pixel(x, y)) - grey(left.pixel(x, y))) > 3.0 ? 1 : 0;
                wrong += std::abs(qBlue(both.pixel(x, y)) - grey(right.pixel(x, y))) > 3.0 ? 1 : 0;
            }
        }
        QCOMPARE(wrong, 0);
        how.stereo = Stereo::RedCyan;
        const QImage colour = draw(scene(), how);
        QVERIFY(pictures::difference(colour, both, 20).pixels > 1000);
        QVERIFY(pictures::difference(colour, left, 20).pixels > 1000);
    }

    void halvesAreThePicturesOfTheEyes()
    {
        const QRect left(0, 0, kWidth / 2, kHeight);
        const QRect upper(0, 0, kWidth, kHeight / 2);
        for (const auto& [stereo, eye, half] : {std::tuple(Stereo::SideBySide, -1, left),
                                                {Stereo::SideBySide, 1, left.translated(kWidth / 2, 0)},
                                                {Stereo::TopBottom, -1, upper},
                                                {Stereo::TopBottom, 1, upper.translated(0, kHeight / 2)}}) {
            Presentation how;
            how.stereo = stereo;
            const QImage shown = draw(scene(), how).copy(half);
            const QImage wanted =
                drawFor(eye, how).scaled(half.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
            QVERIFY(pictures::difference(shown, wanted, 24).pixels < kWidth * kHeight / 2 / 50);
        }
    }

    void flipsTurnThePictureOver()
    {
        const QImage plain = draw(scene());
        for (const auto& [leftRight, upDown] : {std::pair(true, false), {false, true}, {true, true}}) {
            Presentation how;
            how.flipLeftRight = leftRight;
            how.flipUpDown = upDown;
            const QImage turned = draw(scene(), how).mirrored(leftRight, upDown);
            QVERIFY(pictures::difference(plain, turned, 6).pixels < kWidth * kHeight / 500);
        }
    }

private:
    QImage draw(const Scene& scene, const Presentation& how = {})
    {
        return picture(
            [&] { m_presenter->draw(*m_renderer, scene, how, m_camera.distanceMm(), ui::render::Canvas::kSamples); });
    }

    QImage drawFor(int eye, const Presentation& how)
    {
        return draw(Presenter::seenBy(eye, scene(), how, m_camera.distanceMm()));
    }

    static bool isGrey(const Colour& colour, double tolerance = 14.0)
    {
        return std::abs(colour.red - colour.blue) < tolerance;
    }

    static constexpr glm::dvec2 kLesion{support::kLesionX, support::kLesionY};
    std::unique_ptr<Presenter> m_presenter;
};

int main(int argc, char** argv)
{
    const QGuiApplication application(argc, argv);
    TestPresenter test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_presenter.moc"
