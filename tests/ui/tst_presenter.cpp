// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <memory>

#include <glm/geometric.hpp>

#include <QGuiApplication>
#include <QTest>

#include "core/drilling/Bur.h"
#include "tests/support/SyntheticMolar.h"
#include "tests/ui/Pictures.h"
#include "ui/render/Canvas.h"
#include "ui/render/Presenter.h"
#include "ui/tooth/Viewpoint.h"

using ui::render::Canvas;
using ui::render::DentalMirror;
using ui::render::Presentation;
using ui::render::Presenter;
using ui::render::Scene;
using ui::render::Stereo;
using ui::render::ToothSurface;

/// Ways to look at a tooth: mirror, palettes, lights, two eyes, turned over.
class TestPresenter : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void cleanupTestCase();
    void init();
    void theMirrorShowsThePointWhereItsImageStands();
    void depthColoursMarkTheCutAlone();
    void idealColoursTellWhatIsToGoAndWhatIsTooDeep();
    void everyTissueHasItsOwnColourAndPattern();
    void theHandpiecesLightReachesTheWorkAndNotTheShadow();
    void aWetToothShines();
    void theGhostIsFaint();
    void whatLiesInTheScreenIsSeenAlikeByBothEyes();
    void glassesGiveEachEyeItsPicture();
    void halvesAreThePicturesOfTheEyes();
    void flipsTurnThePictureOver();

private:
    QImage draw(const Scene& scene, const Presentation& how = {});
    [[nodiscard]] Scene scene() const { return ui::tooth::sceneThrough(m_camera, {kWidth, kHeight}, false); }
    void cut(glm::dvec2 placeMm, float floorMm)
    {
        m_surface->write(pictures::cutTile(m_surface->anatomy(), placeMm, floorMm));
        m_renderer->update(*m_surface, m_surface->refresh());
    }
    [[nodiscard]] pictures::Colour at(const QImage& image, glm::dvec3 pointMm, int reach = 3) const
    {
        const glm::dvec2 pixel = m_camera.pixelOf(pointMm);
        return pictures::mean(image, pictures::around(pixel.x, pixel.y, reach));
    }

    static constexpr int kWidth = 800;
    static constexpr int kHeight = 600;
    std::unique_ptr<Canvas> m_canvas;
    std::unique_ptr<ui::render::ToothRenderer> m_renderer;
    std::unique_ptr<Presenter> m_presenter;
    std::unique_ptr<ToothSurface> m_surface;
    ui::tooth::Camera m_camera;
};

void TestPresenter::initTestCase()
{
    auto canvas = Canvas::make({kWidth, kHeight});
    QVERIFY2(canvas, "this display offers no OpenGL 3.3 core");
    m_canvas = std::move(*canvas);
    m_renderer = std::make_unique<ui::render::ToothRenderer>();
    m_presenter = std::make_unique<Presenter>();
    QString reason;
    QVERIFY2(m_renderer->initialize(reason) && m_presenter->initialize(reason), qPrintable(reason));
    m_camera.setViewport({kWidth, kHeight});
}

void TestPresenter::cleanupTestCase()
{
    m_canvas->makeCurrent();
    m_presenter.reset();
    m_renderer.reset();
    m_canvas.reset();
}

void TestPresenter::init()
{
    m_canvas->makeCurrent();
    m_surface = std::make_unique<ToothSurface>(support::syntheticMolar(), ui::tooth::operatingLight(false));
    m_renderer->setSurface(*m_surface);
    ui::tooth::showWhole(m_camera, *m_surface);
}

QImage TestPresenter::draw(const Scene& scene, const Presentation& how)
{
    const QImage image =
        m_canvas->picture([&] { m_presenter->draw(*m_renderer, scene, how, m_camera.distanceMm(), Canvas::kSamples); });
    static int count = 0;
    pictures::keep(image, QStringLiteral("presenter_%1_%2").arg(QTest::currentTestFunction()).arg(count++));
    return image;
}

void TestPresenter::theMirrorShowsThePointWhereItsImageStands()
{
    // A mark that is nowhere else: the dark lesion, seen in a mirror above the tooth that looks down on it.
    const glm::dvec2 place(support::kLesionX, support::kLesionY);
    const glm::dvec3 lesion(place, m_surface->heightMm(place));
    m_camera.set(0.0, 12.0, m_camera.fittingMm());
    Scene seen = scene();
    const QImage without = draw(seen);
    DentalMirror mirror;
    mirror.centreMm = lesion + glm::dvec3(0.0, 5.0, 7.0);
    const glm::dvec3 towardsEye = glm::normalize(seen.eyeMm - mirror.centreMm);
    mirror.normal = glm::normalize(towardsEye + glm::normalize(lesion - mirror.centreMm));
    seen.mirror = mirror;
    const QImage with = draw(seen);
    const glm::dvec3 image = mirror.image(lesion);
    const glm::dvec3 beside = mirror.image(lesion + glm::dvec3(-2.4, 0.0, 0.3));
    QVERIFY2(at(with, image).brightness() < 0.6 * at(with, beside).brightness(),
             qPrintable(QStringLiteral("%1 %2").arg(at(with, image).brightness()).arg(at(with, beside).brightness())));
    QVERIFY(at(with, beside).brightness() > 100.0);
    // Where the glass is there was only the room.
    QVERIFY(at(without, image).brightness() < 80.0);
    // The tooth itself is as it was.
    QVERIFY(std::abs(at(with, {0.0, -4.5, -5.0}).brightness() - at(without, {0.0, -4.5, -5.0}).brightness()) < 2.0);
}

void TestPresenter::depthColoursMarkTheCutAlone()
{
    m_camera.set(0.0, 88.0, m_camera.fittingMm());
    const glm::dvec2 place = pictures::tileMiddle(m_surface->lattice(), {2.6, 1.2});
    const double whole = m_surface->heightMm(place);
    Scene seen = scene();
    seen.look.depthColours = ui::render::DepthColours::BelowOriginal;
    cut(place, static_cast<float>(whole - 0.4));
    QVERIFY(std::abs(m_surface->belowUncutMm({place, whole - 0.4}) - 0.4) < 0.05);
    const pictures::Colour shallow = at(draw(seen), {place, whole - 0.4});
    QVERIFY(shallow.blue > 1.2 * shallow.red);
    cut(place, static_cast<float>(whole - 2.8));
    const QImage deep = draw(seen);
    const pictures::Colour floor = at(deep, {place, whole - 2.8});
    QVERIFY(floor.red > 1.3 * floor.blue);
    // What was not cut is grey.
    const glm::dvec2 away(-2.0, 1.8);
    const pictures::Colour uncut = at(deep, {away, m_surface->heightMm(away)});
    QVERIFY(std::abs(uncut.red - uncut.blue) < 14.0);
    QVERIFY(std::abs(m_surface->belowUncutMm({away, m_surface->heightMm(away)})) < 1e-5);
}

void TestPresenter::idealColoursTellWhatIsToGoAndWhatIsTooDeep()
{
    m_camera.set(0.0, 88.0, m_camera.fittingMm());
    const core::terrain::ToothAnatomy& tooth = m_surface->anatomy();
    const auto ideal = core::grading::idealCavity(tooth);
    QVERIFY(ideal != nullptr);
    m_surface->setIdeal(ideal);
    m_renderer->setSurface(*m_surface);
    Scene seen = scene();
    seen.look.depthColours = ui::render::DepthColours::AgainstIdeal;
    const glm::dvec2 place(support::kLesionX, support::kLesionY);
    const glm::dvec2 node = glm::round(tooth.grid.latticeOf(place));
    const float floor = (*ideal)[tooth.grid.index(static_cast<int>(node.x), static_cast<int>(node.y))];
    const double whole = m_surface->heightMm(place);
    QVERIFY(whole - static_cast<double>(floor) > 0.8);
    const pictures::Colour toGo = at(draw(seen), {place, whole});
    QVERIFY2(toGo.blue > 1.3 * toGo.red, qPrintable(QString("%1 %2").arg(toGo.red).arg(toGo.blue)));
    cut(place, floor);
    const pictures::Colour right = at(draw(seen), {place, static_cast<double>(floor)});
    QVERIFY(std::abs(right.red - right.blue) < 25.0);
    cut(place, floor - 1.0F);
    const QImage deep = draw(seen);
    const pictures::Colour tooDeep = at(deep, {place, static_cast<double>(floor) - 1.0});
    QVERIFY(tooDeep.red > 1.3 * tooDeep.blue);
    const glm::dvec2 away(-2.6, 1.8);
    const pictures::Colour sound = at(deep, {away, m_surface->heightMm(away)});
    QVERIFY(std::abs(sound.red - sound.blue) < 14.0);
}

void TestPresenter::everyTissueHasItsOwnColourAndPattern()
{
    m_camera.set(0.0, 88.0, 0.6 * m_camera.fittingMm());
    const glm::dvec2 place = pictures::tileMiddle(m_surface->lattice(), {-1.6, 0.4});
    const glm::dvec2 node = glm::round(m_surface->anatomy().grid.latticeOf(place));
    const core::terrain::ColumnLayers& column = m_surface->anatomy().layers.at(
        m_surface->anatomy().grid.index(static_cast<int>(node.x), static_cast<int>(node.y)));
    Scene seen = scene();
    seen.look.palette = ui::render::Palette::Distinct;
    const auto contrast = [&](const QImage& image, glm::dvec3 middle) {
        const glm::dvec2 pixel = m_camera.pixelOf(middle);
        double least = 255.0;
        double most = 0.0;
        for (int y = -14; y <= 14; ++y) {
            for (int x = -14; x <= 14; ++x) {
                const double grey = qGray(image.pixel(qRound(pixel.x) + x, qRound(pixel.y) + y));
                least = std::min(least, grey);
                most = std::max(most, grey);
            }
        }
        return most - least;
    };
    const glm::dvec3 onEnamel(-2.0, 1.8, m_surface->heightMm({-2.0, 1.8}));
    const QImage whole = draw(seen);
    const pictures::Colour enamel = at(whole, onEnamel);
    QVERIFY(enamel.red > 1.3 * enamel.blue);  // yellow, and plain
    cut(place, column.dej - 0.3F);
    const QImage inDentin = draw(seen);
    const glm::dvec3 onDentin(place, column.dej - 0.3F);
    QVERIFY2(contrast(inDentin, onDentin) > 12.0, qPrintable(QString::number(contrast(inDentin, onDentin))));
    const pictures::Colour dentin = at(inDentin, onDentin, 12);
    QVERIFY(dentin.red > 1.8 * dentin.blue);
    const float pulpMm = 0.5F * (column.pulpRoof + column.pulpFloor);
    cut(place, pulpMm);
    const QImage inPulp = draw(seen);
    QVERIFY2(contrast(inPulp, {place, pulpMm}) > 12.0, qPrintable(QString::number(contrast(inPulp, {place, pulpMm}))));
    const pictures::Colour pulp = at(inPulp, {place, pulpMm}, 12);
    QVERIFY(pulp.blue > 1.1 * pulp.green);  // purple
    const glm::dvec3 onDecay(support::kLesionX, support::kLesionY,
                             m_surface->heightMm({support::kLesionX, support::kLesionY}));
    const pictures::Colour decay = at(whole, onDecay);
    QVERIFY(decay.blue > 1.3 * decay.red);
}

void TestPresenter::theHandpiecesLightReachesTheWorkAndNotTheShadow()
{
    const glm::dvec2 place = pictures::tileMiddle(m_surface->lattice(), {0.0, 0.5});
    const auto floor = static_cast<float>(m_surface->heightMm(place) - 2.0);
    cut(place, floor);
    m_camera.set(0.0, 80.0, m_camera.fittingMm());
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
    // The lamp sits on the side of the handle: it reaches the floor's far side, not what is under the near wall.
    const glm::dvec3 open(place + glm::dvec2(-0.35, 0.0), floor);
    QVERIFY2(gain(open) > 8.0, qPrintable(QString::number(gain(open))));
    const glm::dvec2 aside(-4.2, -2.5);
    QVERIFY2(gain({aside, m_surface->heightMm(aside)}) < gain(open),
             qPrintable(QString::number(gain({aside, m_surface->heightMm(aside)}))));
}

void TestPresenter::aWetToothShines()
{
    Scene seen = scene();
    const auto brightest = [](const QImage& image) {
        int pixels = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                pixels += qGray(image.pixel(x, y)) > 240 ? 1 : 0;
        return pixels;
    };
    cut(pictures::tileMiddle(m_surface->lattice(), {2.6, 1.2}), -3.0F);
    const int dry = brightest(draw(seen));
    seen.look.isWet = true;
    const int wet = brightest(draw(seen));
    QVERIFY2(wet > dry, qPrintable(QStringLiteral("%1 %2").arg(wet).arg(dry)));
}

void TestPresenter::theGhostIsFaint()
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
    // It is seen through.
    QVERIFY(pictures::difference(without, with, 120).pixels < ghost.pixels / 10);
    const glm::dvec2 tip = m_camera.pixelOf({0.0, 0.0, -1.0});
    QVERIFY(ghost.box.contains(qRound(tip.x), qRound(tip.y)));
}

void TestPresenter::whatLiesInTheScreenIsSeenAlikeByBothEyes()
{
    const Scene seen = scene();
    Presentation how;
    how.stereo = Stereo::RedCyan;
    const double focus = m_camera.distanceMm();
    const auto across = [&](int eye, double share) {
        const Scene one = Presenter::seenBy(eye, seen, how, focus);
        const glm::dvec4 point = glm::inverse(seen.eyeFromTooth) * glm::dvec4(1.3, 0.7, -share * focus, 1.0);
        const glm::dvec4 clip = one.clipFromEye * one.eyeFromTooth * point;
        return clip.x / clip.w;
    };
    QVERIFY(std::abs(across(-1, 1.0) - across(1, 1.0)) < 1.0e-9);
    QVERIFY(across(-1, 0.8) > across(1, 0.8) + 1.0e-3);  // before the screen: crossed
    QVERIFY(across(-1, 1.2) < across(1, 1.2) - 1.0e-3);  // behind it: not
    // The eyes are as far apart as was asked.
    const double apart =
        glm::distance(Presenter::seenBy(-1, seen, how, focus).eyeMm, Presenter::seenBy(1, seen, how, focus).eyeMm);
    QVERIFY(std::abs(apart - how.apart * focus) < 1.0e-9);
}

void TestPresenter::glassesGiveEachEyeItsPicture()
{
    const Scene seen = scene();
    Presentation how;
    how.stereo = Stereo::RedCyanGrey;
    const QImage both = draw(seen, how);
    const QImage left = draw(Presenter::seenBy(-1, seen, how, m_camera.distanceMm()));
    const QImage right = draw(Presenter::seenBy(1, seen, how, m_camera.distanceMm()));
    int wrong = 0;
    for (int y = 0; y < kHeight; y += 3) {
        for (int x = 0; x < kWidth; x += 3) {
            const auto grey = [&](const QImage& image) {
                const QRgb p = image.pixel(x, y);
                return 0.299 * qRed(p) + 0.587 * qGreen(p) + 0.114 * qBlue(p);
            };
            wrong += std::abs(qRed(both.pixel(x, y)) - grey(left)) > 3.0 ? 1 : 0;
            wrong += std::abs(qBlue(both.pixel(x, y)) - grey(right)) > 3.0 ? 1 : 0;
        }
    }
    QCOMPARE(wrong, 0);
    how.stereo = Stereo::RedCyan;
    const QImage colour = draw(seen, how);
    QVERIFY(pictures::difference(colour, both, 20).pixels > 1000);
    QVERIFY(pictures::difference(colour, left, 20).pixels > 1000);
}

void TestPresenter::halvesAreThePicturesOfTheEyes()
{
    const Scene seen = scene();
    Presentation how;
    how.stereo = Stereo::SideBySide;
    const QImage beside = draw(seen, how);
    const QImage left = draw(Presenter::seenBy(-1, seen, how, m_camera.distanceMm()))
                            .scaled(kWidth / 2, kHeight, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    const QImage right = draw(Presenter::seenBy(1, seen, how, m_camera.distanceMm()))
                             .scaled(kWidth / 2, kHeight, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    const int share = kWidth * kHeight / 2 / 50;
    QVERIFY(pictures::difference(beside.copy(0, 0, kWidth / 2, kHeight), left, 24).pixels < share);
    QVERIFY(pictures::difference(beside.copy(kWidth / 2, 0, kWidth / 2, kHeight), right, 24).pixels < share);
    how.stereo = Stereo::TopBottom;
    const QImage above = draw(seen, how);
    const QImage upper = draw(Presenter::seenBy(-1, seen, how, m_camera.distanceMm()))
                             .scaled(kWidth, kHeight / 2, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    QVERIFY(pictures::difference(above.copy(0, 0, kWidth, kHeight / 2), upper, 24).pixels < share);
}

void TestPresenter::flipsTurnThePictureOver()
{
    const Scene seen = scene();
    const QImage plain = draw(seen);
    for (const auto& [leftRight, upDown] : {std::pair(true, false), {false, true}, {true, true}}) {
        Presentation how;
        how.flipLeftRight = leftRight;
        how.flipUpDown = upDown;
        const QImage turned = draw(seen, how).mirrored(leftRight, upDown);
        QVERIFY(pictures::difference(plain, turned, 6).pixels < kWidth * kHeight / 500);
    }
}

int main(int argc, char** argv)
{
    const QGuiApplication application(argc, argv);
    TestPresenter test;
    return QTest::qExec(&test, argc, argv);
}

#include "tst_presenter.moc"
