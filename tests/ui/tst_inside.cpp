// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of the inside of a tooth: sections and X-ray pictures, without a window where none is needed.
#include <QApplication>
#include <QImage>
#include <QPainter>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>

#include <cmath>
#include <numbers>

#include "core/servo/ServoState.h"
#include "core/teeth/Laid.h"
#include "core/teeth/ToothBuilder.h"
#include "tests/support/Checks.h"
#include "tests/support/Suite.h"
#include "tests/support/SyntheticMolar.h"
#include "tests/support/SyntheticTooth.h"
#include "tests/support/Tables.h"
#include "tests/ui/Pictures.h"
#include "ui/inside/RadiographPicture.h"
#include "ui/inside/SectionPainter.h"
#include "ui/inside/SectionView.h"
#include "ui/inside/XrayPage.h"
#include "ui/kit/Actions.h"
#include "ui/kit/TabularDigitsLabel.h"
#include "ui/kit/Theme.h"
#include "ui/text/Texts.h"

using namespace ui;
using core::terrain::Material;
using core::terrain::Tooth;
using support::near;

namespace {

constexpr double kQuarter = std::numbers::pi / 2.0;

/// Returns a block 6.4 mm wide: enamel from 0 to -2, dentin to -10, pulp from -7 to -5 throughout.
std::shared_ptr<core::terrain::ToothAnatomy> block()
{
    auto anatomy = support::slab(-2.0F);
    anatomy->name = "block.stl";
    for (core::terrain::ColumnLayers& column : anatomy->layers) {
        column.pulpRoof = -5.0F;
        column.pulpFloor = -7.0F;
    }
    return anatomy;
}

inside::SectionScene sceneOf(const Tooth& tooth, const core::imaging::SectionPlane& plane)
{
    inside::SectionScene scene;
    scene.tooth = &tooth;
    scene.plane = plane;
    return scene;
}

QImage painted(const inside::SectionScene& scene, double pixelRatio = 1.0)
{
    QImage image(QSize(400, 480) * pixelRatio, QImage::Format_RGB32);
    image.setDevicePixelRatio(pixelRatio);
    image.fill(Qt::magenta);
    QPainter painter(&image);
    inside::paintSection(painter, QRectF(0, 0, 400, 480), scene);
    return image;
}

/// Returns the number of pixels in a rectangle that have the colour of a material.
int count(const QImage& image, const QRect& part, Material material)
{
    const QRgb fill = ui::kit::materialLook(material).fill.rgb();
    return pictures::count(image.copy(part), [&](QRgb pixel) { return pixel == fill; });
}

QRect column(const QImage& image, int x)
{
    return {x, 0, 1, image.height()};
}

/// An X-ray page that takes pictures of a tooth.
struct Films
{
    Films() { page.resize(1000, 700); }

    /// Returns the X-ray picture of a tooth.
    [[nodiscard]] QImage of(const Tooth& tooth)
    {
        page.setTooth(tooth);
        return developed();
    }
    [[nodiscard]] QImage developed()
    {
        return QTest::qWaitFor([&] { return page.isReady(); }) ? page.bothFilms() : QImage();
    }

    QWidget window;
    ui::kit::Actions actions{&window};
    inside::XrayPage page{actions, nullptr};
};

}  // namespace

class TestInside : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase()
    {
        QLocale::setDefault(QLocale("en_GB"));
        ui::kit::applyTheme(*qApp, ui::kit::ThemeChoice::Light);
    }

    void layersAreAsThickAsTheyAre_data()
    {
        support::columns<double, double>("angleRad", "pixelRatio");
        QTest::newRow("mesio-distal") << 0.0 << 1.0;
        QTest::newRow("bucco-lingual") << kQuarter << 1.0;
        QTest::newRow("turned") << 0.5 << 1.0;
        QTest::newRow("on a dense screen") << 0.0 << 2.0;
    }

    void layersAreAsThickAsTheyAre()
    {
        QFETCH(double, angleRad);
        QFETCH(double, pixelRatio);
        const Tooth tooth(block());
        const QImage image = painted(sceneOf(tooth, {{0.0, 0.0}, angleRad}), pixelRatio);
        // The block and its layers are drawn at the same scale. A grid line takes a pixel in each millimetre.
        int widest = 0;
        for (int y = 0; y < image.height(); ++y)
            widest = std::max(widest, count(image, {0, y, image.width(), 1}, Material::Dentin));
        QVERIFY(widest > 100);
        const QRect middle = column(image, image.width() / 2 + 3);
        const double acrossMm = 6.4 / std::max(std::abs(std::cos(angleRad)), std::abs(std::sin(angleRad)));
        const double pxPerMm = (widest + 6.0) / acrossMm;
        for (const Material material : {Material::Enamel, Material::Pulp})
            QVERIFY(near(count(image, middle, material), 2.0 * pxPerMm, 5.0 * pixelRatio));
    }

    void theBurHasItsTrueSize()
    {
        const Tooth tooth(block());
        const core::bur::Bur& fissure = core::bur::burs()[3];
        inside::SectionScene scene = sceneOf(tooth, {{0.4, 0.0}, 0.0});
        const QImage without = painted(scene);
        scene.bur = &fissure;
        scene.tipMm = {0.4, 0.0, -3.0};
        const QRect bur = pictures::difference(without, painted(scene), 0).box;
        // The enamel is 2 mm high, which gives the scale of the picture.
        constexpr int kBeside = 120;
        const double pxPerMm = count(without, column(without, kBeside), Material::Enamel) / 2.0;
        QVERIFY(pxPerMm > 20.0);
        QVERIFY(near((bur.right() - bur.left()) / pxPerMm, 2.0 * fissure.headRadiusMm, 0.12));
        int surface = 0;
        while (surface < without.height() && count(without, {kBeside, surface, 1, 1}, Material::Enamel) == 0)
            ++surface;
        QVERIFY(near((bur.bottom() - surface) / pxPerMm, 3.0, 0.12));
    }

    void aCutIsOpenAndTheOldSurfaceStays()
    {
        Tooth tooth(block());
        const QImage whole = painted(sceneOf(tooth, {}));
        for (int j = 0; j < 64; ++j)
            for (int i = 24; i < 40; ++i)
                tooth.top[tooth.grid().index(i, j)] = -3.0F;
        const QImage cut = painted(sceneOf(tooth, {}));
        const QRect middle = column(cut, cut.width() / 2 + 3);
        QVERIFY(count(whole, middle, Material::Enamel) > 40);
        QCOMPARE(count(cut, middle, Material::Enamel), 0);
        const auto turquoise = [&](const QImage& image) {
            return pictures::count(image.copy(middle),
                                   [](QRgb p) { return qBlue(p) > 150 && qRed(p) < 130 && qGreen(p) > 150; });
        };
        QVERIFY(turquoise(cut) >= 1);
        QCOMPARE(turquoise(cut), turquoise(whole));
    }

    void sidesOfAScanAreNotNamed()
    {
        struct Row
        {
            int fdi;
            const char* name;
            double angleRad;
            const char* direction;
            const char* plane;
        };
        for (const Row& row : {Row{36, "36", 0.0, "distal", "Bucco-lingual"},
                               {36, "36", kQuarter, "lingual", "Bucco-lingual"},
                               {26, "26", kQuarter, "buccal", "Bucco-palatal"},
                               {26, "26", -kQuarter, "palatal", "Bucco-palatal"},
                               {21, "21", kQuarter, "labial", "Labio-palatal"},
                               {36, "36", 1.5 * kQuarter, "mesiolingual", "Bucco-lingual"},
                               {36, "mine.stl", 0.0, "+x", "Along y"},
                               {0, "mine.stl", -kQuarter, "−y", "Along y"},
                               {0, "mine.stl", 1.5 * kQuarter, "−x +y", "Along y"}}) {
            core::terrain::ToothAnatomy anatomy;
            anatomy.fdi = row.fdi;
            anatomy.name = row.name;
            QCOMPARE(text::directionName(anatomy, row.angleRad), QString::fromUtf8(row.direction));
            QCOMPARE(text::planeAlongY(anatomy), QString(row.plane));
        }
    }

    /// Names of sides and planes refer to the tooth, whichever side of it is up.
    void sidesOfALaidToothAreNamed()
    {
        struct Row
        {
            int fdi;
            const char* side;
            double tiltDeg;
            double angleRad;
            const char* direction;
        };
        for (const Row& row : {Row{33, "buccal", 90.0, 0.0, "distal"},
                               {33, "buccal", 90.0, kQuarter, "incisal"},
                               {33, "buccal", 90.0, -kQuarter, "apical"},
                               {33, "buccal", 90.0, 0.5 * kQuarter, "distal / incisal"},
                               {21, "mesial", 90.0, 0.0, "incisal"},
                               {21, "mesial", 90.0, kQuarter, "labial"},
                               {36, "lingual", 90.0, -kQuarter, "occlusal"},
                               {36, "buccal", 45.0, kQuarter, "lingual / occlusal"},
                               {36, "buccal", 10.0, kQuarter, "lingual"}}) {
            core::terrain::ToothAnatomy anatomy;
            anatomy.fdi = row.fdi;
            anatomy.name = std::to_string(row.fdi);
            anatomy.lying = core::teeth::findLying(row.side, row.tiltDeg, row.fdi).value();
            QCOMPARE(text::directionName(anatomy, row.angleRad), QString(row.direction));
            // A film is in the tooth's own frame.
            QCOMPARE(text::sideName(anatomy, 0.0), QString("distal"));
        }
        core::terrain::ToothAnatomy scan;
        scan.name = "mine.stl";
        scan.lying = core::teeth::findLying("-y", 90.0, 0).value();
        QCOMPARE(text::directionName(scan, 0.0), QString("+x"));
        QCOMPARE(text::directionName(scan, kQuarter), QString("occlusal"));
    }

    void theDecayOfTheUsualToothIsSeen()
    {
        core::teeth::BuildOptions options;
        const auto decayed = core::teeth::buildTooth({36}, options);
        options.caries.reset();
        const auto sound = core::teeth::buildTooth({36}, options);
        QVERIFY(decayed.has_value() && sound.has_value());
        const auto film = [](const Tooth& tooth) {
            const core::imaging::XrayedTooth one{&tooth};
            const core::imaging::FilmArea area = core::imaging::shadowArea(std::span(&one, 1), {}, 1.0);
            return inside::radiographPicture(std::span(&one, 1), {}, area, inside::kFilmPixelMm, {});
        };
        const QImage with = film(Tooth(decayed->anatomy));
        const QImage without = film(Tooth(sound->anatomy));
        QCOMPARE(with.size(), without.size());
        int most = 0;
        int lightest = 0;
        int seen = 0;
        for (int y = 0; y < with.height(); ++y)
            for (int x = 0; x < with.width(); ++x) {
                const int darker = qGray(without.pixel(x, y)) - qGray(with.pixel(x, y));
                most = std::max(most, darker);
                seen += darker >= 10 ? 1 : 0;
                lightest = std::max(lightest, qGray(with.pixel(x, y)));
            }
        const double seenMm2 = seen * inside::kFilmPixelMm * inside::kFilmPixelMm;
        QVERIFY(qGray(with.pixel(3, 3)) <= 4);
        QVERIFY(lightest > 200 && lightest < 255);
        QVERIFY(most >= 30);
        QVERIFY(seenMm2 > 1.0);
    }

    void filmsOfUpperTeethHangCrownDown_data() { support::rows<int>("fdi", {21, 24, 26, 31, 34, 36}); }

    /// The half of the film with the crown is the lighter one.
    void filmsOfUpperTeethHangCrownDown()
    {
        QFETCH(int, fdi);
        const auto built = core::teeth::buildTooth({fdi}, {});
        QVERIFY(built.has_value());
        const Tooth tooth(built->anatomy);
        const core::imaging::XrayedTooth one{&tooth};
        const core::imaging::FilmArea area = core::imaging::shadowArea(std::span(&one, 1), {}, 1.0);
        const QImage film = inside::radiographPicture(std::span(&one, 1), {}, area, 0.1, {});
        const QRect upper(0, 0, film.width(), film.height() / 2);
        const double above = pictures::mean(film, upper).brightness();
        const double below = pictures::mean(film, upper.translated(0, upper.height())).brightness();
        QVERIFY(fdi < 30 ? below > 1.2 * above : above > 1.2 * below);
    }

    void thePanelFollowsTheBur()
    {
        const auto anatomy = block();
        Tooth tooth(anatomy);
        const core::imaging::PulpChamber pulp(*anatomy);
        inside::SectionView view(nullptr);
        view.resize(344, 600);
        view.show();
        core::servo::ServoState servo;
        servo.tick = 1;
        servo.anchorMm = {0.5, 0.5, -1.0};
        const auto figure = [&](const char* name) {
            return view.findChild<ui::kit::TabularDigitsLabel*>(QLatin1String(name))->text();
        };
        const auto follow = [&](std::uint64_t revision) {
            view.follow(&tooth, revision, servo, core::imaging::readDepth(tooth, pulp, servo.anchorMm));
        };
        follow(1);
        QCOMPARE(figure("sectionDepth"), QString("1.00"));
        QCOMPARE(figure("sectionDentin"), QString("3.00"));
        QCOMPARE(figure("sectionDown"), QString("4.00"));
        QCOMPARE(figure("sectionNearest"), QString("4.00"));
        const QImage before = view.grab().toImage();
        servo.anchorMm.z = -2.5;
        const auto follows = [&](const QString& depth) {
            follow(1);
            return figure("sectionDepth") == depth;
        };
        QTRY_VERIFY(follows("2.50"));
        QVERIFY(view.grab().toImage() != before);
        servo.anchorMm = {9.0, 0.5, -2.5};
        QTRY_VERIFY(follows(QString::fromUtf8("–")));
        QVERIFY(figure("sectionNearest") != QString::fromUtf8("–"));
        view.setFiguresShown(false);
        QVERIFY(!view.findChild<ui::kit::TabularDigitsLabel*>("sectionDepth")->isVisible());
    }

    void thePlaneIsChosenAndTurned()
    {
        inside::SectionView view(nullptr);
        QCOMPARE(view.angleDeg(), 90);
        view.findChild<QPushButton*>("sectionAlongX")->click();
        QCOMPARE(view.angleDeg(), 0);
        QVERIFY(view.findChild<QPushButton*>("sectionAlongX")->isChecked());
        QVERIFY(!view.findChild<QPushButton*>("sectionAlongY")->isChecked());
        view.turn();
        QCOMPARE(view.angleDeg(), 15);
        QVERIFY(!view.findChild<QPushButton*>("sectionAlongX")->isChecked());
        view.findChild<QSlider*>("sectionAngle")->setValue(172);
        view.turn();
        QCOMPARE(view.angleDeg(), 0);
    }

    void filmsAreDevelopedAndSaved()
    {
        Films films;
        QVERIFY(films.page.bothFilms().isNull());
        Tooth tooth(support::syntheticMolar(64));
        const QImage whole = films.of(tooth);
        QVERIFY(whole.width() > whole.height());
        for (float& top : tooth.top)
            if (top > core::terrain::kEmptyTop)
                top -= 1.0F;
        // The left half is unchanged, the right half is not.
        const QImage cut = films.of(tooth);
        const QRect left(0, 0, whole.width() / 2, whole.height());
        const QRect right = left.translated(left.width(), 0);
        QCOMPARE(cut.copy(left), whole.copy(left));
        QVERIFY(cut.copy(right) != whole.copy(right));
        QSignalSpy asked(&films.page, &inside::XrayPage::saveRequested);
        films.page.findChild<QPushButton*>("saveFilms")->click();
        QCOMPARE(asked.size(), 1);
    }

    void moreExposureDarkensTheFilm()
    {
        Films films;
        const auto brightness = [](const QImage& both) { return pictures::mean(both, both.rect()).brightness(); };
        const double before = brightness(films.of(Tooth(support::syntheticMolar(64))));
        // The slider moves faster than films are developed: the last value counts.
        auto* exposure = films.page.findChild<QSlider*>("exposure");
        for (int step = 1; step <= 6; ++step)
            exposure->setValue(step);
        QVERIFY(brightness(films.developed()) < 0.8 * before);
    }

    void aBitewingNeedsATooth()
    {
        Films films;
        auto* bitewing = films.page.findChild<QPushButton*>("bitewing");
        const auto built = core::teeth::buildTooth({36}, {});
        QVERIFY(built.has_value());
        const auto shape = [](const QImage& both) { return both.width() / static_cast<double>(both.height()); };
        const double one = shape(films.of(Tooth(built->anatomy)));
        QVERIFY(bitewing->isEnabled());
        bitewing->click();
        QVERIFY2(shape(films.developed()) > 1.3 * one, "three crowns are wider than one tooth");
        QVERIFY(!films.of(Tooth(block())).isNull());
        QVERIFY(!bitewing->isEnabled());
        QVERIFY(films.page.findChild<QPushButton*>("oneTooth")->isChecked());
    }
};

CUSP_TEST(TestInside)
#include "tst_inside.moc"
