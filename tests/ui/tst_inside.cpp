// SPDX-License-Identifier: GPL-3.0-or-later
// What is painted of a tooth's inside: sections and X-ray pictures, without a window where none is needed.
#include <QApplication>
#include <QImage>
#include <QPainter>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>

#include <cmath>
#include <numbers>

#include "core/teeth/ToothBuilder.h"
#include "tests/support/SyntheticMolar.h"
#include "ui/inside/RadiographPicture.h"
#include "ui/inside/SectionPainter.h"
#include "ui/inside/SectionView.h"
#include "ui/inside/XrayPage.h"
#include "ui/shell/Actions.h"
#include "ui/shell/TabularLabel.h"
#include "ui/shell/Theme.h"
#include "ui/text/Texts.h"

using namespace ui;
using core::terrain::Material;
using core::terrain::Tooth;

namespace {

constexpr double kQuarter = std::numbers::pi / 2.0;

/// A block of 64 x 64 cells of 0.125 mm around the origin, 8 mm wide: enamel from 0 to -2, dentin to -12, pulp from -7
/// to -5 over the whole of it.
std::shared_ptr<core::terrain::ToothAnatomy> block()
{
    auto anatomy = std::make_shared<core::terrain::ToothAnatomy>();
    anatomy->name = "block.stl";
    anatomy->grid.side = 64;
    anatomy->grid.cellMm = 0.125;
    anatomy->grid.originMm = glm::dvec2(-0.125 * 31.5);
    anatomy->top.assign(anatomy->grid.count(), 0.0F);
    anatomy->bottom.assign(anatomy->grid.count(), -12.0F);
    anatomy->areaMm2.assign(anatomy->grid.count(), 0.125F * 0.125F);
    anatomy->layers.assign(anatomy->grid.count(), {0.0F, 0.0F, -2.0F, -5.0F, -7.0F});
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

/// How many pixels of the row have this colour, but for the lines of the grid.
int countInRow(const QImage& image, int y, const QColor& colour)
{
    int count = 0;
    for (int x = 0; x < image.width(); ++x)
        count += image.pixelColor(x, y) == colour ? 1 : 0;
    return count;
}

int countInColumn(const QImage& image, int x, const QColor& colour)
{
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        count += image.pixelColor(x, y) == colour ? 1 : 0;
    return count;
}

bool near(double actual, double expected, double tolerance)
{
    if (std::abs(actual - expected) <= tolerance)
        return true;
    qWarning("%g is not %g", actual, expected);
    return false;
}

}  // namespace

class TestInside : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void layersAreAsThickAsTheyAre_data();
    void layersAreAsThickAsTheyAre();
    void theBurHasItsTrueSize();
    void aCutIsOpenAndTheOldSurfaceStays();
    void sidesOfAScanAreNotNamed_data();
    void sidesOfAScanAreNotNamed();
    void theDecayOfTheUsualToothIsSeen();
    void thePanelFollowsTheBur();
    void thePlaneIsChosenAndTurned();
    void filmsAreDevelopedAndSaved();
    void moreExposureDarkensTheFilm();
    void aBitewingNeedsATooth();
};

void TestInside::initTestCase()
{
    QLocale::setDefault(QLocale("en_GB"));
    shell::applyTheme(*qApp, shell::ThemeChoice::Light);
}

void TestInside::layersAreAsThickAsTheyAre_data()
{
    QTest::addColumn<double>("angleRad");
    QTest::addColumn<double>("pixelRatio");
    QTest::newRow("mesio-distal") << 0.0 << 1.0;
    QTest::newRow("bucco-lingual") << kQuarter << 1.0;
    QTest::newRow("turned") << 0.5 << 1.0;
    QTest::newRow("on a dense screen") << 0.0 << 2.0;
}

void TestInside::layersAreAsThickAsTheyAre()
{
    QFETCH(double, angleRad);
    QFETCH(double, pixelRatio);
    const Tooth tooth(block());
    const QImage image = painted(sceneOf(tooth, {{0.0, 0.0}, angleRad}), pixelRatio);
    const auto colour = [](Material material) { return shell::materialLook(material).fill; };
    // The widths of the block and of its layers have one scale. Grid lines take a pixel in each millimetre.
    int widest = 0;
    for (int y = 0; y < image.height(); ++y)
        widest = std::max(widest, countInRow(image, y, colour(Material::Dentin)));
    QVERIFY(widest > 100);
    const int x = image.width() / 2 + 3;
    const double enamelPx = countInColumn(image, x, colour(Material::Enamel));
    const double pulpPx = countInColumn(image, x, colour(Material::Pulp));
    const double acrossMm = 8.0 / std::max(std::abs(std::cos(angleRad)), std::abs(std::sin(angleRad)));
    const double pxPerMm = (widest + 8.0) / acrossMm;
    QVERIFY(near(enamelPx, 2.0 * pxPerMm, 5.0 * pixelRatio));
    QVERIFY(near(pulpPx, 2.0 * pxPerMm, 5.0 * pixelRatio));
}

void TestInside::theBurHasItsTrueSize()
{
    const Tooth tooth(block());
    const core::drilling::Bur& fissure = core::drilling::burs()[3];
    inside::SectionScene scene = sceneOf(tooth, {{0.4, 0.0}, 0.0});
    const QImage without = painted(scene);
    scene.bur = &fissure;
    scene.tipMm = {0.4, 0.0, -3.0};
    const QImage with = painted(scene);
    int left = with.width();
    int right = 0;
    int bottom = 0;
    for (int y = 0; y < with.height(); ++y)
        for (int x = 0; x < with.width(); ++x)
            if (with.pixel(x, y) != without.pixel(x, y)) {
                left = std::min(left, x);
                right = std::max(right, x);
                bottom = std::max(bottom, y);
            }
    // The enamel is 2 mm high: the scale of the picture.
    const double pxPerMm = countInColumn(without, 90, shell::materialLook(Material::Enamel).fill) / 2.0;
    QVERIFY(pxPerMm > 20.0);
    QVERIFY(near((right - left) / pxPerMm, 2.0 * fissure.headRadiusMm, 0.12));
    int surface = 0;
    while (surface < without.height() && without.pixelColor(90, surface) != shell::materialLook(Material::Enamel).fill)
        ++surface;
    QVERIFY(near((bottom - surface) / pxPerMm, 3.0, 0.12));
}

void TestInside::aCutIsOpenAndTheOldSurfaceStays()
{
    const auto anatomy = block();
    Tooth tooth(anatomy);
    const QImage whole = painted(sceneOf(tooth, {}));
    for (int j = 0; j < 64; ++j)
        for (int i = 24; i < 40; ++i)
            tooth.top[anatomy->grid.index(i, j)] = -3.0F;
    const QImage cut = painted(sceneOf(tooth, {}));
    const int x = cut.width() / 2 + 3;
    const QColor enamel = shell::materialLook(Material::Enamel).fill;
    QVERIFY(countInColumn(whole, x, enamel) > 40);
    QCOMPARE(countInColumn(cut, x, enamel), 0);
    const auto turquoise = [&](const QImage& image) {
        int count = 0;
        for (int y = 0; y < image.height(); ++y) {
            const QColor here = image.pixelColor(x, y);
            count += here.blue() > 150 && here.red() < 130 && here.green() > 150 ? 1 : 0;
        }
        return count;
    };
    QVERIFY(turquoise(cut) >= 1);
    QCOMPARE(turquoise(cut), turquoise(whole));
}

void TestInside::sidesOfAScanAreNotNamed_data()
{
    QTest::addColumn<int>("fdi");
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("angleRad");
    QTest::addColumn<QString>("direction");
    QTest::addColumn<QString>("plane");
    QTest::newRow("lower molar") << 36 << "36" << 0.0 << "distal"
                                 << "Bucco-lingual";
    QTest::newRow("lower molar, y") << 36 << "36" << kQuarter << "lingual"
                                    << "Bucco-lingual";
    QTest::newRow("upper molar, y") << 26 << "26" << kQuarter << "buccal"
                                    << "Bucco-palatal";
    QTest::newRow("upper molar, -y") << 26 << "26" << -kQuarter << "palatal"
                                     << "Bucco-palatal";
    QTest::newRow("upper incisor, y") << 21 << "21" << kQuarter << "labial"
                                      << "Labio-palatal";
    QTest::newRow("lower molar, turned") << 36 << "36" << 1.5 * kQuarter << "mesiolingual"
                                         << "Bucco-lingual";
    QTest::newRow("scan of a molar") << 36 << "mine.stl" << 0.0 << "+x"
                                     << "Along y";
    QTest::newRow("scan, -y") << 0 << "mine.stl" << -kQuarter << QString::fromUtf8("−y") << "Along y";
    QTest::newRow("scan, turned") << 0 << "mine.stl" << 1.5 * kQuarter << QString::fromUtf8("−x +y") << "Along y";
}

void TestInside::sidesOfAScanAreNotNamed()
{
    QFETCH(int, fdi);
    QFETCH(QString, name);
    QFETCH(double, angleRad);
    QFETCH(QString, direction);
    QFETCH(QString, plane);
    core::terrain::ToothAnatomy anatomy;
    anatomy.fdi = fdi;
    anatomy.name = name.toStdString();
    QCOMPARE(text::directionName(anatomy, angleRad), direction);
    QCOMPARE(text::planeAlongY(anatomy), plane);
}

void TestInside::theDecayOfTheUsualToothIsSeen()
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
    qInfo("air %d, lightest %d; decay darker by at most %d, by 10 or more on %.2f mm2", qGray(with.pixel(3, 3)),
          lightest, most, seenMm2);
    QVERIFY(qGray(with.pixel(3, 3)) <= 4);
    QVERIFY(lightest > 200 && lightest < 255);
    QVERIFY(most >= 30);
    QVERIFY(seenMm2 > 1.0);
}

void TestInside::thePanelFollowsTheBur()
{
    const auto anatomy = block();
    Tooth tooth(anatomy);
    const core::imaging::PulpChamber pulp(*anatomy);
    inside::SectionView view(nullptr);
    view.resize(344, 600);
    view.show();
    core::session::ServoState servo;
    servo.tick = 1;
    servo.anchorMm = {0.5, 0.5, -1.0};
    const auto figure = [&](const char* name) {
        return view.findChild<shell::TabularLabel*>(QLatin1String(name))->text();
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
    QVERIFY(!view.findChild<shell::TabularLabel*>("sectionDepth")->isVisible());
}

void TestInside::thePlaneIsChosenAndTurned()
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

void TestInside::filmsAreDevelopedAndSaved()
{
    QWidget window;
    shell::Actions actions(&window);
    inside::XrayPage page(actions, nullptr);
    page.resize(1000, 700);
    QVERIFY(page.bothFilms().isNull());
    const auto anatomy = support::syntheticMolar(64);
    Tooth tooth(anatomy);
    page.setTooth(tooth);
    QTRY_VERIFY(page.isReady());
    const QImage whole = page.bothFilms();
    QVERIFY(whole.width() > whole.height());
    for (float& top : tooth.top)
        if (top > core::terrain::kEmptyTop)
            top -= 1.0F;
    page.setTooth(tooth);
    QTRY_VERIFY(page.isReady());
    // The left half is as it was, the right one is not.
    const QImage cut = page.bothFilms();
    const QRect left(0, 0, whole.width() / 2, whole.height());
    const QRect right(whole.width() / 2, 0, whole.width() / 2, whole.height());
    QCOMPARE(cut.copy(left), whole.copy(left));
    QVERIFY(cut.copy(right) != whole.copy(right));
    QSignalSpy asked(&page, &inside::XrayPage::saveRequested);
    page.findChild<QPushButton*>("saveFilms")->click();
    QCOMPARE(asked.size(), 1);
}

void TestInside::moreExposureDarkensTheFilm()
{
    QWidget window;
    shell::Actions actions(&window);
    inside::XrayPage page(actions, nullptr);
    page.resize(1000, 700);
    page.setTooth(Tooth(support::syntheticMolar(64)));
    const auto brightness = [&] {
        const QImage both = page.bothFilms();
        double sum = 0.0;
        for (int y = 0; y < both.height(); y += 3)
            for (int x = 0; x < both.width(); x += 3)
                sum += qGray(both.pixel(x, y));
        return sum;
    };
    QTRY_VERIFY(page.isReady());
    const double before = brightness();
    // Faster than films are developed: the last wish counts.
    auto* exposure = page.findChild<QSlider*>("exposure");
    for (int step = 1; step <= 6; ++step)
        exposure->setValue(step);
    QTRY_VERIFY(page.isReady());
    QVERIFY(brightness() < 0.8 * before);
}

void TestInside::aBitewingNeedsATooth()
{
    QWidget window;
    shell::Actions actions(&window);
    inside::XrayPage page(actions, nullptr);
    page.resize(1000, 700);
    auto* bitewing = page.findChild<QPushButton*>("bitewing");
    const auto built = core::teeth::buildTooth({36}, {});
    QVERIFY(built.has_value());
    page.setTooth(Tooth(built->anatomy));
    QTRY_VERIFY(page.isReady());
    const double one = page.bothFilms().width() / static_cast<double>(page.bothFilms().height());
    QVERIFY(bitewing->isEnabled());
    bitewing->click();
    QTRY_VERIFY(page.isReady());
    const double three = page.bothFilms().width() / static_cast<double>(page.bothFilms().height());
    QVERIFY2(three > 1.3 * one, "three crowns are wider than one tooth");
    page.setTooth(Tooth(block()));
    QVERIFY(!bitewing->isEnabled());
    QVERIFY(page.findChild<QPushButton*>("oneTooth")->isChecked());
    QTRY_VERIFY(page.isReady());
}

QTEST_MAIN(TestInside)
#include "tst_inside.moc"
