// SPDX-License-Identifier: GPL-3.0-or-later
// Charts as pictures: whole, legible without colour, the same as SVG and as PNG.
#include <QApplication>
#include <QImage>
#include <QPainter>
#include <QSvgRenderer>
#include <QTest>
#include <QXmlStreamReader>

#include "app/cli/bench/Contestants.h"
#include "app/cli/bench/charts/Sheet.h"

using namespace app::cli::bench;

namespace {

const QString kFooter =
    "Some processor, 2 cores | 2026-01-01T00:00:00Z | Cusp 0.1.0, GCC 12.2.0, Release, plain kernels";

Chart curves()
{
    CurveChart content;
    content.x = {"time (us)", 1.0, 2000.0, 10.0};
    content.y = {"error (um)", 0.1, 1000.0, 10.0};
    content.limits = {{"noticed", 50.0, false}, {"too late", 1000.0, true}};
    content.goodCorner = "good";
    for (int k = 0; k < 5; ++k)
        content.curves << Curve{QString("method %1").arg(k),
                                k,
                                {{3.0 + k, 0.2 * (k + 1)}, {10.0 + 5 * k, 2.0 + 10 * k}, {100.0, 100.0 + 100 * k}},
                                {"first", "second", "third"}};
    return {"curves", "Curves", "One line about it\nand another", content};
}

Chart linear()
{
    CurveChart content;
    content.x = {"grid", -0.2, 2.2, 0.0, 1.0, {"small", "middling", "large"}};
    content.y = {"lag (um)", -10.0, 300.0, 0.0, 50.0, {}};
    content.curves << Curve{"one", 0, {{0.0, 0.0}, {1.0, 100.0}, {2.0, 290.0}}, {}};
    return {"linear", "Linear", "", content};
}

Chart bars()
{
    BarChart content;
    content.valueTitle = "N/mm";
    content.most = 24.0;
    content.interval = 5.0;
    content.groupTitle = "delay (ms)";
    content.groups = QStringList{"0", "1"};
    for (const char* hand : {"light", "firm"}) {
        BarChart::Panel panel{hand, {}};
        for (int k = 0; k < 5; ++k)
            panel.bars << BarChart::Bars{QString("method %1").arg(k), k, {1.0 + k, 20.0 - k}, {"low", "high"}};
        content.panels << panel;
    }
    return {"bars", "Bars", "About bars", content};
}

Chart map()
{
    MapChart content;
    content.findings = {{"q", "#DDEDEA", "quiet"}, {"Z", "#A33A00", "wild"}};
    content.columns = QStringList{"0", "1", "2", "4"};
    content.columnTitle = "delay, ms";
    for (int group = 0; group < 5; ++group)
        content.groups << QString("method %1").arg(group);
    for (int row = 0; row < 19; ++row) {
        content.rows << QString("scene %1").arg(row);
        QList<MapChart::Cell> cells;
        for (int column = 0; column < 20; ++column)
            cells << ((row + column) % 3 == 0 ? MapChart::Cell{1, "10/12"} : MapChart::Cell{0, {}});
        content.cells << cells;
    }
    return {"map", "Map", "About the map", content};
}

QImage rendered(QByteArray svg)
{
    svg.replace(", DejaVu Sans, Arial, sans-serif", "");  // Qt takes the list for one name
    QSvgRenderer renderer(svg);
    QImage image(kChartWidth, kChartHeight, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    renderer.render(&painter);
    return image;
}

}  // namespace

class TestBenchCharts : public QObject
{
    Q_OBJECT
private slots:
    void everyKindIsAWholePicture_data();
    void everyKindIsAWholePicture();
    void svgAndPngShowTheSame_data();
    void svgAndPngShowTheSame();
    void allCellsOfAMapAreDrawn();
    void allPointsAndLimitsAreNamed();
    void barsAreAsHighAsTheirValues();
    void svgIsSmall();
    void methodsDifferWithoutColour();
};

void TestBenchCharts::everyKindIsAWholePicture_data()
{
    QTest::addColumn<int>("kind");
    QTest::newRow("curves") << 0;
    QTest::newRow("linear") << 1;
    QTest::newRow("bars") << 2;
    QTest::newRow("map") << 3;
}

namespace {

Chart chartOfKind(int kind)
{
    return kind == 0 ? curves() : kind == 1 ? linear() : kind == 2 ? bars() : map();
}

}  // namespace

void TestBenchCharts::everyKindIsAWholePicture()
{
    QFETCH(int, kind);
    const Chart chart = chartOfKind(kind);
    const Pictures pictures = draw(chart, kFooter);
    const QImage png = QImage::fromData(pictures.png, "PNG");
    QCOMPARE(png.size(), QSize(kChartWidth, kChartHeight));
    QXmlStreamReader svg(pictures.svg);
    QVERIFY(svg.readNextStartElement());
    QCOMPARE(svg.name(), u"svg");
    QCOMPARE(svg.attributes().value("viewBox"), QString("0 0 %1 %2").arg(kChartWidth).arg(kChartHeight));
    while (!svg.atEnd())
        svg.readNext();
    QVERIFY2(!svg.hasError(), qPrintable(svg.errorString()));
    QVERIFY(pictures.svg.contains(">" + chart.title.toUtf8() + "</text>"));
    QVERIFY(pictures.svg.contains(">" + kFooter.toUtf8() + "</text>"));
    // Nothing runs out of the picture.
    constexpr int kEdge = 6;
    for (int x = 0; x < png.width(); ++x)
        for (int y = 0; y < png.height(); ++y)
            if (x < kEdge || y < kEdge || x >= png.width() - kEdge || y >= png.height() - kEdge)
                QVERIFY2(png.pixelColor(x, y) == Qt::white, qPrintable(QString("ink at %1, %2").arg(x).arg(y)));
}

void TestBenchCharts::svgAndPngShowTheSame_data()
{
    // Qt reads no hatching out of an SVG, so bars are left out.
    QTest::addColumn<int>("kind");
    QTest::newRow("curves") << 0;
    QTest::newRow("linear") << 1;
    QTest::newRow("map") << 3;
}

void TestBenchCharts::svgAndPngShowTheSame()
{
    QFETCH(int, kind);
    const Pictures pictures = draw(chartOfKind(kind), kFooter);
    // An eighth of the size: letters may sit a fraction of a pixel apart.
    const auto small = [](const QImage& image) {
        return image.scaled(kChartWidth / 8, kChartHeight / 8, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    };
    const QImage png = small(QImage::fromData(pictures.png, "PNG"));
    const QImage svg = small(rendered(pictures.svg));
    int apart = 0;
    for (int x = 0; x < png.width(); ++x)
        for (int y = 0; y < png.height(); ++y)
            apart += std::abs(qGray(png.pixel(x, y)) - qGray(svg.pixel(x, y))) > 40 ? 1 : 0;
    if (apart > 0) {
        png.save(QString(CUSP_BINARY_DIR "/tests/chart_%1_png.png").arg(kind));
        svg.save(QString(CUSP_BINARY_DIR "/tests/chart_%1_svg.png").arg(kind));
    }
    QVERIFY2(apart < png.width() * png.height() / 200, qPrintable(QString("%1 pixels differ").arg(apart)));
}

void TestBenchCharts::allCellsOfAMapAreDrawn()
{
    const Chart chart = map();
    const auto& content = std::get<MapChart>(chart.content);
    const Pictures pictures = draw(chart, kFooter);
    qsizetype wild = 0;
    qsizetype all = 0;
    for (const auto& row : content.cells)
        for (const MapChart::Cell& cell : row) {
            wild += cell.finding;
            ++all;
        }
    QCOMPARE(all, 19 * 20);
    // Once more each in the legend.
    QCOMPARE(pictures.svg.count(">Z</text>"), wild + 1);
    QCOMPARE(pictures.svg.count(">q</text>"), all - wild + 1);
    QCOMPARE(pictures.svg.count(">10/12</text>"), wild);
    for (const QString& row : content.rows)
        QVERIFY2(pictures.svg.contains(">" + row.toUtf8() + "</text>"), qPrintable(row));
    // As many cells as that have the colour's area in the picture: more than half of each is not letters.
    const QImage png = QImage::fromData(pictures.png, "PNG");
    int coloured = 0;
    for (int x = 0; x < png.width(); ++x)
        for (int y = 0; y < png.height(); ++y)
            coloured += png.pixelColor(x, y) == QColor(0xA3, 0x3A, 0x00) ? 1 : 0;
    constexpr int kCellPx = 60 * 30;
    QVERIFY2(coloured > wild * kCellPx / 2, qPrintable(QString::number(coloured)));
}

void TestBenchCharts::allPointsAndLimitsAreNamed()
{
    const QByteArray svg = draw(curves(), kFooter).svg;
    for (const char* note : {"first", "second", "third"})
        QCOMPARE(svg.count(QByteArray(">") + note + "</text>"), 5);
    for (const char* text : {"noticed", "too late", "good", "time (us)", "error (um)"})
        QVERIFY2(svg.contains(QByteArray(">") + text + "</text>"), text);
    for (int k = 0; k < 5; ++k)
        QVERIFY(svg.contains(QByteArray(">method ") + QByteArray::number(k)));
    const QByteArray labelled = draw(linear(), kFooter).svg;
    for (const char* text : {"small", "middling", "large", "0", "250"})
        QVERIFY2(labelled.contains(QByteArray(">") + text + "</text>"), text);
}

void TestBenchCharts::barsAreAsHighAsTheirValues()
{
    // The solid bars of the first method: the second of 20 is twenty times as high as the first of 1.
    const QImage png = QImage::fromData(draw(bars(), kFooter).png, "PNG");
    QList<int> heights;
    bool inside = false;
    for (int x = 0; x < png.width(); ++x) {
        int height = 0;
        for (int y = 200; y < 560; ++y)  // the upper panel
            height += png.pixelColor(x, y) == lookOf(0).colour ? 1 : 0;
        if (height > 5 && !inside)
            heights << 0;
        inside = height > 5;
        if (inside)
            heights.last() = std::max(heights.last(), height);
    }
    QCOMPARE(heights.size(), 2);
    QVERIFY2(std::abs(heights[1] / 20.0 - heights[0]) <= 3.0,
             qPrintable(QString("%1, %2").arg(heights[0]).arg(heights[1])));
}

void TestBenchCharts::svgIsSmall()
{
    for (int kind = 0; kind < 4; ++kind) {
        const qsizetype bytes = draw(chartOfKind(kind), kFooter).svg.size();
        QVERIFY2(bytes < 150'000, qPrintable(QString("kind %1: %2 bytes").arg(kind).arg(bytes)));
    }
}

void TestBenchCharts::methodsDifferWithoutColour()
{
    for (const Contestant& one : contestants())
        for (const Contestant& other : contestants()) {
            if (&one == &other)
                continue;
            const Look& a = lookOf(one.look);
            const Look& b = lookOf(other.look);
            QVERIFY(a.marker != b.marker && a.line != b.line && a.hatching != b.hatching && a.colour != b.colour);
        }
}

QTEST_MAIN(TestBenchCharts)
#include "tst_bench_charts.moc"
