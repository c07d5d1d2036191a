// SPDX-License-Identifier: GPL-3.0-or-later
// Charts tell their values in words, and give them away as pictures and tables.
#include <QAction>
#include <QApplication>
#include <QBuffer>
#include <QChart>
#include <QChartView>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QGraphicsScene>
#include <QGraphicsSimpleTextItem>
#include <QGraphicsTextItem>
#include <QImage>
#include <QLabel>
#include <QPainter>
#include <QSignalSpy>
#include <QSvgGenerator>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include <memory>

#include "tests/support/FullDisk.h"
#include "ui/charts/ChartPanel.h"
#include "ui/charts/Drawing.h"
#include "ui/charts/Table.h"
#include "ui/shell/Theme.h"

using namespace ui::charts;

namespace {

Chart curve()
{
    Curve made;
    made.x = {"Attempt", 0.5, 6.5, false, true};
    made.y = {"Points", 0.0, 100.0, false, false};
    Line score{"Score", {}, Mark::None, true};
    Line passed{"Passed", {}, Mark::Circle, false};
    Line failed{"Not passed", {}, Mark::HollowDiamond, false};
    for (int k = 1; k <= 6; ++k) {
        const Dot dot{double(k), 40.0 + 8.5 * k, QString("Attempt %1: %2 points").arg(k).arg(40.0 + 8.5 * k), 100 + k};
        score.dots << dot;
        (k > 4 ? passed : failed).dots << dot;
        made.band.slices << Slice{double(k), 40.0 + 4 * k, 52.0 + 5 * k, 66.0 + 4 * k, QString("class %1").arg(k)};
    }
    made.band.name = "Middle half of the class";
    made.band.middleName = "Median";
    made.lines = {score, passed, failed};
    made.limits = {{75.0, false, "Pass mark"}};
    return {"Score over attempts", "23 people", "Nothing yet", made};
}

Chart bars()
{
    Bars made;
    made.value = {"Points lost", 0.0, 30.0, false, false};
    made.nameTitle = "Criterion";
    made.bars = {{"Depth of the pulpal floor against the ideal", 24.0, "Depth: 24.0 points lost"},
                 {"Walls", 6.0, "Walls: 6.0 points lost"},
                 {"=cmd|' /C calc'!A0", 1.5, "Odd: 1.5"}};
    return {"What cost points", {}, "Nothing yet", made};
}

Chart histogram()
{
    Histogram made;
    made.x = {"Points", 0.0, 100.0, false, false};
    made.count = {"Students", 0.0, 10.0, false, true};
    for (int k = 0; k < 10; ++k)
        made.bins << Histogram::Bin{10.0 * k, 10.0 * (k + 1), k, QString("%1 students").arg(k)};
    made.limits = {{75.0, true, "Pass mark"}};
    return {"Best scores", "45 people", "Nothing yet", made};
}

}  // namespace

class TestCharts : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void arrowsWalkFromValueToValue();
    void thePointerFindsValues();
    void barsAndColumnsAreMetAnywhere();
    void enterOpensWhatAValueStandsFor();
    void withoutValuesItSaysWhatWillBeHere();
    void aBandWithoutLinesIsWalkedItself();
    void tablesAreSafeForSpreadsheets_data();
    void tablesAreSafeForSpreadsheets();
    void numbersOfTablesKnowNoLanguage();
    void aChartIsATable();
    void everySeriesOfATableHasAName();
    void filesAreWritten();
    void whatCannotBeWrittenIsSaid();
    void picturesShowSomethingInBothThemes_data();
    void picturesShowSomethingInBothThemes();
    void axesEndAtRoundNumbers();
    void barsThatBeginAlikeAreToldApart();
    void aFileSaysWhoseItIs();
    void namesOfBarsAreSeenWhole_data();
    void namesOfBarsAreSeenWhole();
    void numbersOfALyingAxisAreNotCut_data();
    void numbersOfALyingAxisAreNotCut();
    void namesHaveTheRoomThatIsThereWhenTheyCome();
    void aShortNameIsBetterThanNoBar();
    void noWordIsCutWhereOthersCanBeLeftOut();
    void theKeyIsSeenWhole();
    void aFileThatIsSavedMovesNothing();
    void thatAFileWasSavedGoesByItself();
    void whatChangesOftenIsDrawnOnce();
    void whatIsHiddenIsDrawnWhenItIsShown();
    void theSameOnceMoreLeavesWhatIsTold();

private:
    /// The names of bars as they are drawn, each inside the chart and before its axis; empty: one is not.
    [[nodiscard]] QStringList namesDrawn() const;

    std::unique_ptr<ChartPanel> m_panel;
};

void TestCharts::initTestCase()
{
    QLocale::setDefault(QLocale("en_GB"));
}

void TestCharts::init()
{
    m_panel = std::make_unique<ChartPanel>(nullptr);
    m_panel->setAutoFillBackground(true);
    m_panel->resize(560, 360);
    m_panel->setChart(curve());
    m_panel->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_panel.get()));
    m_panel->activateWindow();
    m_panel->setFocus();
}

void TestCharts::arrowsWalkFromValueToValue()
{
    QVERIFY(!m_panel->stop());
    QTest::keyClick(m_panel.get(), Qt::Key_Right);
    QCOMPARE(m_panel->said(), QString("Attempt 1: 48.5 points"));
    QCOMPARE(m_panel->accessibleDescription(), m_panel->said());
    QTest::keyClick(m_panel.get(), Qt::Key_Right);
    QCOMPARE(m_panel->said(), QString("Attempt 2: 57 points"));
    QTest::keyClick(m_panel.get(), Qt::Key_End);
    QTest::keyClick(m_panel.get(), Qt::Key_Right);
    QCOMPARE(m_panel->said(), QString("Attempt 6: 91 points"));
    QTest::keyClick(m_panel.get(), Qt::Key_Home);
    QTest::keyClick(m_panel.get(), Qt::Key_Left);
    QCOMPARE(m_panel->said(), QString("Attempt 1: 48.5 points"));
    auto* callout = m_panel->findChild<QLabel*>("chartCallout");
    QVERIFY(callout->isVisible());
    QVERIFY(m_panel->rect().contains(callout->geometry()));
}

void TestCharts::thePointerFindsValues()
{
    auto* viewport = m_panel->findChild<QAbstractScrollArea*>()->viewport();
    QSet<QString> told;
    for (int y = 0; y < viewport->height(); y += 6)
        for (int x = 0; x < viewport->width(); x += 6) {
            QMouseEvent move(QEvent::MouseMove, QPointF(x, y), viewport->mapToGlobal(QPointF(x, y)), Qt::NoButton,
                             Qt::NoButton, Qt::NoModifier);
            QApplication::sendEvent(viewport, &move);
            if (m_panel->stop())
                told << m_panel->said();
        }
    QCOMPARE(told.size(), 6);
}

void TestCharts::barsAndColumnsAreMetAnywhere()
{
    for (const Chart& chart : {bars(), histogram()}) {
        m_panel->setChart(chart);
        QTest::qWait(1);
        auto* viewport = m_panel->findChild<QAbstractScrollArea*>()->viewport();
        QSet<QString> told;
        for (int y = 4; y < viewport->height(); y += 8)
            for (int x = 4; x < viewport->width(); x += 8) {
                QMouseEvent move(QEvent::MouseMove, QPointF(x, y), viewport->mapToGlobal(QPointF(x, y)), Qt::NoButton,
                                 Qt::NoButton, Qt::NoModifier);
                QApplication::sendEvent(viewport, &move);
                told << m_panel->said();
            }
        told.remove({});
        QCOMPARE(told.size(), stopsOf(chart).size());
    }
}

void TestCharts::enterOpensWhatAValueStandsFor()
{
    QSignalSpy chosen(m_panel.get(), &ChartPanel::chosen);
    QTest::keyClick(m_panel.get(), Qt::Key_Return);
    QCOMPARE(chosen.count(), 0);
    QTest::keyClick(m_panel.get(), Qt::Key_Home);
    QTest::keyClick(m_panel.get(), Qt::Key_Return);
    QCOMPARE(chosen.count(), 1);
    QCOMPARE(chosen.front().front().toLongLong(), 101);
}

void TestCharts::withoutValuesItSaysWhatWillBeHere()
{
    m_panel->setChart({"Score", {}, "After your first attempt there is a point here.", Curve{}});
    QCOMPARE(m_panel->findChild<QLabel*>("chartEmpty")->text(),
             QString("After your first attempt there is a point here."));
    QVERIFY(m_panel->findChild<QLabel*>("chartEmpty")->isVisible());
    QVERIFY(!m_panel->findChild<QWidget*>("saveChart")->isVisible());
    QTest::keyClick(m_panel.get(), Qt::Key_Right);
    QVERIFY(!m_panel->stop());
    QVERIFY(png(m_panel->chart()).isEmpty());
}

void TestCharts::aBandWithoutLinesIsWalkedItself()
{
    Chart chart = curve();
    std::get<Curve>(chart.content).lines.clear();
    m_panel->setChart(chart);
    QTest::keyClick(m_panel.get(), Qt::Key_Home);
    QCOMPARE(m_panel->said(), QString("class 1"));
}

void TestCharts::tablesAreSafeForSpreadsheets_data()
{
    QTest::addColumn<QString>("words");
    QTest::addColumn<QByteArray>("written");
    QTest::newRow("plain") << "Depth" << QByteArray("Depth");
    QTest::newRow("comma") << "a,b" << QByteArray("\"a,b\"");
    QTest::newRow("quote") << "a\"b" << QByteArray("\"a\"\"b\"");
    QTest::newRow("two lines") << "a\nb" << QByteArray("\"a\nb\"");
    QTest::newRow("umlaut") << QString::fromUtf8("Höhe") << QByteArray("Höhe");
    QTest::newRow("formula") << "=1+1" << QByteArray("'=1+1");
    QTest::newRow("sum") << "+1" << QByteArray("'+1");
    QTest::newRow("minus") << "-1" << QByteArray("'-1");
    QTest::newRow("at") << "@SUM(A1)" << QByteArray("'@SUM(A1)");
    QTest::newRow("tab") << "\t=1" << QByteArray("'\t=1");
    QTest::newRow("space and formula") << " =1" << QByteArray("' =1");
    QTest::newRow("link") << "=HYPERLINK(\"http://x\",\"y\")"
                          << QByteArray("\"'=HYPERLINK(\"\"http://x\"\",\"\"y\"\")\"");
    QTest::newRow("wide equals sign") << QString::fromUtf8("＝1") << QByteArray("'＝1");
}

void TestCharts::tablesAreSafeForSpreadsheets()
{
    QFETCH(QString, words);
    QFETCH(QByteArray, written);
    QCOMPARE(csv({{"head"}, {{words}}}), "head\r\n" + written + "\r\n");
}

void TestCharts::numbersOfTablesKnowNoLanguage()
{
    QLocale::setDefault(QLocale("de_DE"));
    // The last bit of a sum is nobody's measure.
    QCOMPARE(csv({{"a"}, {{0.1 + 0.2}}}), "a\r\n0.3\r\n");
    const QByteArray text = csv({{"a", "b", "c"}, {{-1234.5, std::int64_t{-1234567}, qQNaN()}}});
    QLocale::setDefault(QLocale("en_GB"));
    QCOMPARE(text, QByteArray("a,b,c\r\n-1234.5,-1234567,\r\n"));
}

void TestCharts::aChartIsATable()
{
    const Table table = tableOf(curve());
    QCOMPARE(table.heads, QStringList({"series", "Attempt", "Points"}));
    QCOMPARE(table.rows.size(), 6 + 3 * 6 + 1);
    const Table lost = tableOf(bars());
    QCOMPARE(lost.rows.size(), 3);
    QVERIFY(csv(lost).contains("'=cmd"));
    Chart timed = curve();
    std::get<Curve>(timed.content).x.isTime = true;
    std::get<Curve>(timed.content).lines[1].dots[0].x = 1'763'633'700'000.0;
    QVERIFY(csv(tableOf(timed)).contains("2025-11-20T10:15:00Z"));
}

void TestCharts::everySeriesOfATableHasAName()
{
    Chart chart = curve();
    auto& content = std::get<Curve>(chart.content);
    content.lines = {Line{{}, {Dot{1.0, 48.5, {}, 0}}, Mark::Circle, false}};
    QVERIFY(!csv(tableOf(chart)).contains("\r\n,"));  // the band says it already
    QVERIFY(!csv(tableOf(chart)).contains("48.5"));
    content.band = {};
    QVERIFY(csv(tableOf(chart)).contains("\r\nPoints,1,48.5\r\n"));
}

void TestCharts::filesAreWritten()
{
    const QTemporaryDir folder;
    for (const char* name : {"chart.png", "chart.svg", "chart.csv"}) {
        const QString path = folder.filePath(name);
        QVERIFY2(m_panel->save(path), name);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray bytes = file.readAll();
        if (path.endsWith("png")) {
            QCOMPARE(QImage::fromData(bytes).size(), QSize(1920, 1200));
        } else if (path.endsWith("svg")) {
            QXmlStreamReader reader(bytes);
            while (!reader.atEnd())
                reader.readNext();
            QVERIFY(!reader.hasError());
            QVERIFY(bytes.contains("Score over attempts"));
        } else {
            QCOMPARE(bytes, csv(tableOf(curve())));
        }
    }
    QCOMPARE(m_panel->findChild<QLabel*>("chartSaved")->text(), QString("Saved: chart.csv"));
}

void TestCharts::whatCannotBeWrittenIsSaid()
{
    QVERIFY(!m_panel->save("/nowhere/at/all/chart.png"));
    QVERIFY(m_panel->findChild<QLabel*>("chartSaved")->text().startsWith("chart.png could not be written"));
    const QTemporaryDir folder;
    const QString file = folder.filePath("small.csv");
    {
        const support::FullDisk full(10);
        QVERIFY(!m_panel->save(file));
    }
    QVERIFY(!QFile::exists(file));
    QVERIFY(m_panel->findChild<QLabel*>("chartSaved")->text().startsWith("small.csv could not be written"));
}

void TestCharts::picturesShowSomethingInBothThemes_data()
{
    QTest::addColumn<bool>("dark");
    QTest::addColumn<int>("which");
    for (const bool dark : {false, true})
        for (int which = 0; which < 3; ++which)
            QTest::addRow("%s %d", dark ? "dark" : "light", which) << dark << which;
}

void TestCharts::picturesShowSomethingInBothThemes()
{
    QFETCH(bool, dark);
    QFETCH(int, which);
    ui::shell::applyTheme(*qApp, dark ? ui::shell::ThemeChoice::Dark : ui::shell::ThemeChoice::Light);
    m_panel->setChart(which == 0 ? curve() : which == 1 ? bars() : histogram());
    QTest::qWait(20);
    m_panel->setStop(1);
    const QImage picture = m_panel->grab().toImage();
    // The marks of the first line are there, in the theme's colour.
    const QColor accent = ui::shell::tones(m_panel->palette()).accent;
    int seen = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            seen += picture.pixelColor(x, y) == accent ? 1 : 0;

    QVERIFY2(seen > 40, qPrintable(QString::number(seen)));
}

void TestCharts::axesEndAtRoundNumbers()
{
    QCOMPARE(roundEnd(0.0), 1.0);
    QCOMPARE(roundEnd(1.0), 1.0);
    QCOMPARE(roundEnd(1.2), 2.0);
    QCOMPARE(roundEnd(22.0), 25.0);
    QCOMPARE(roundEnd(0.3), 0.5);
    QCOMPARE(roundEnd(6100.0), 10000.0);
}

void TestCharts::barsThatBeginAlikeAreToldApart()
{
    // With room for two lines beside a bar, and with none.
    for (const int count : {6, 14, 18}) {
        Bars many;
        many.value = {"Points lost", 0.0, 30.0, false, false};
        for (int k = 0; k < count; ++k)
            many.bars << Bars::Bar{
                QString("Leeway at the walls of the cavity and its floor, where %1").arg(k), 2.0, {}};
        const QString drawn = QString::fromUtf8(svg({"Much", {}, {}, many}));
        for (int k = 0; k < count; ++k)
            QVERIFY2(drawn.contains(QString("where %1<").arg(k)), qPrintable(QString("%1 of %2").arg(k).arg(count)));
    }
}

void TestCharts::aFileSaysWhoseItIs()
{
    Chart mine = histogram();
    mine.of = "Year 1, Decay on 36";
    const QByteArray told = svg(mine);
    QVERIFY(told.contains("Year 1, Decay on 36"));
    QVERIFY(told != svg(histogram()));
    m_panel->setChart(mine);
    QVERIFY(!m_panel->findChild<QLabel*>("chartTitle")->text().contains("Year"));  // the page says so itself
    m_panel->findChild<QAction*>("saveCSV")->trigger();
    auto* dialog = m_panel->findChild<QFileDialog*>();
    QVERIFY(dialog != nullptr);
    QCOMPARE(QFileInfo(dialog->selectedFiles().front()).fileName(), QString("Best scores, Year 1, Decay on 36.csv"));
    dialog->reject();
}

QStringList TestCharts::namesDrawn() const
{
    const auto* view = m_panel->findChild<QChartView*>();
    QStringList names;
    for (const QGraphicsItem* item : view->scene()->items(Qt::DescendingOrder)) {
        const auto* name = qgraphicsitem_cast<const QGraphicsSimpleTextItem*>(item);
        if (name == nullptr)
            continue;
        const QRectF box = name->sceneBoundingRect();
        const QRectF plot = view->chart()->plotArea();
        if (box.left() < 0.0 || box.right() > plot.left() || box.top() < plot.top() - 2.0 ||
            box.bottom() > plot.bottom() + 2.0)
            return {};
        names << name->text().simplified();
    }
    return names;
}

void TestCharts::namesOfBarsAreSeenWhole_data()
{
    QTest::addColumn<QSize>("size");
    QTest::addColumn<int>("shown");
    QTest::newRow("in a small window") << QSize(450, 290) << 5;
    QTest::newRow("in a large one") << QSize(720, 400) << 13;
}

void TestCharts::namesOfBarsAreSeenWhole()
{
    QFETCH(QSize, size);
    QFETCH(int, shown);
    Bars lost;
    lost.value = {"Verlorene Punkte", 0.0, 30.0, false, false};
    for (int k = 0; k < 20; ++k)
        lost.bars << Bars::Bar{k == 1   ? QString("Gesunde Substanz neben der Karies entfernt")
                               : k == 2 ? QString("Gesunde Substanz neben der Öffnung entfernt")
                                        : QString("Verbliebene Karies %1").arg(k),
                               2.0,
                               {}};
    m_panel->resize(size);
    m_panel->setChart({"Was Punkte kostet", "Mittel der letzten 3 Versuche", {}, lost});
    QTRY_VERIFY(namesDrawn().contains("Gesunde Substanz neben der Karies entfernt"));
    QVERIFY(namesDrawn().contains("Gesunde Substanz neben der Öffnung entfernt"));
    QVERIFY2(namesDrawn().size() >= shown, qPrintable(QString::number(namesDrawn().size())));
}

void TestCharts::numbersOfALyingAxisAreNotCut_data()
{
    QTest::addColumn<Chart>("chart");
    QTest::addColumn<int>("widthPx");
    Bars lost;
    lost.value = {"Verloren, % dessen, was es zählt", 0.0, 100.0, false, false};
    for (int k = 0; k < 5; ++k)
        lost.bars << Bars::Bar{QString("Gesunde Substanz neben der Karies entfernt %1").arg(k), 20.0 * k, {}};
    Histogram scores;
    scores.x = {"Punkte", 0.0, 100.0, false, false};
    scores.count = {"Studierende", 0.0, 10.0, false, true};
    scores.bins = {{0.0, 10.0, 3, "0–10: 3"}, {90.0, 100.0, 4, "90–100: 4"}};
    for (const int widthPx : {200, 260, 330, 450, 900}) {
        QTest::addRow("bars, %d px", widthPx) << Chart{"Schwierigkeit", {}, {}, lost} << widthPx;
        QTest::addRow("columns, %d px", widthPx) << Chart{"Verteilung", {}, {}, scores} << widthPx;
    }
}

/// Qt cuts those that have less room than it wants: "0 ... ... ...".
void TestCharts::numbersOfALyingAxisAreNotCut()
{
    QFETCH(Chart, chart);
    QFETCH(int, widthPx);
    m_panel->resize(widthPx, 290);
    m_panel->setChart(chart);
    const auto labels = [this] {
        QStringList words;
        for (const QGraphicsItem* item : m_panel->findChild<QChartView*>()->scene()->items())
            if (const auto* label = qgraphicsitem_cast<const QGraphicsTextItem*>(item);
                label != nullptr && label->isVisible() && !label->toPlainText().isEmpty())
                words << label->toPlainText();
        return words;
    };
    QTRY_VERIFY2(labels().contains("100"), qPrintable(labels().join(" | ")));
    for (const QString& label : labels())
        QVERIFY2(!label.startsWith("...") && !label.startsWith(u'…'), qPrintable(labels().join(" | ")));
}

void TestCharts::namesHaveTheRoomThatIsThereWhenTheyCome()
{
    m_panel->setChart({"What cost points", {}, "Nothing yet", Curve()});
    m_panel->resize(900, 500);
    m_panel->setChart(bars());
    QTRY_VERIFY(namesDrawn().contains("Depth of the pulpal floor against the ideal"));
}

void TestCharts::aShortNameIsBetterThanNoBar()
{
    Bars lost;
    lost.value = {"Lost", 0.0, 30.0, false, false};
    for (int k = 0; k < 5; ++k)
        lost.bars << Bars::Bar{QString("Gesunde Substanz neben der Karies entfernt %1").arg(k), 2.0, {}};
    const Chart chart{"What cost points", {}, {}, lost};
    QVERIFY(rowsFor(chart, {300.0, 160.0}) >= 5);
    for (int k = 5; k < 20; ++k)
        lost.bars << lost.bars.front();
    QVERIFY(rowsFor({"What cost points", {}, {}, lost}, {300.0, 160.0}) < 5);  // not all would have room
}

void TestCharts::noWordIsCutWhereOthersCanBeLeftOut()
{
    Bars many;
    many.value = {"Points lost", 0.0, 30.0, false, false};
    const QString name = "Leeway at the walls of the cavity and its floor, where it is the narrowest";
    const QStringList words = name.split(u' ');
    many.bars = QList<Bars::Bar>(5, {name, 2.0, {}});
    m_panel->resize(450, 200);  // a line for each
    m_panel->setChart({"What cost points", {}, {}, many});
    QTRY_COMPARE(namesDrawn().size(), 5);
    const QString drawn = namesDrawn().front();
    QVERIFY2(drawn.contains(u'…') && drawn.startsWith("Leeway") && drawn.endsWith("narrowest"), qPrintable(drawn));
    for (const QString& word : drawn.split(u' '))
        QVERIFY2(word == QStringLiteral("…") || words.contains(word), qPrintable(drawn));
}

void TestCharts::theKeyIsSeenWhole()
{
    m_panel->resize(450, 330);
    QByteArray drawn;
    QBuffer buffer(&drawn);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    QPainter painter(&generator);
    m_panel->findChild<QChartView*>()->scene()->render(&painter);
    painter.end();
    for (const char* name :
         {">Middle half of the class<", ">Median<", ">Pass mark<", ">Score<", ">Passed<", ">Not passed<"})
        QVERIFY2(drawn.contains(name), name);
}

void TestCharts::aFileThatIsSavedMovesNothing()
{
    const QTemporaryDir folder;
    const auto* view = m_panel->findChild<QChartView*>();
    const QRect before = view->geometry();
    QVERIFY(m_panel->save(folder.filePath("chart.csv")));
    QCoreApplication::processEvents();
    QVERIFY(m_panel->findChild<QLabel*>("chartSaved")->isVisible());
    QCOMPARE(view->geometry(), before);
    m_panel->setChart(curve());
    QCoreApplication::processEvents();
    QCOMPARE(view->geometry(), before);
}

/// It lies over the chart; that it could not be saved stays.
void TestCharts::thatAFileWasSavedGoesByItself()
{
    const QTemporaryDir folder;
    const auto* said = m_panel->findChild<QLabel*>("chartSaved");
    QVERIFY(m_panel->save(folder.filePath("chart.csv")));
    QVERIFY(said->isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(!said->isVisible(), 15000);
    QVERIFY(m_panel->save(folder.filePath("chart.csv")));
    QVERIFY(!m_panel->save("/nowhere/at/all/chart.png"));
    QTest::qWait(7000);
    QVERIFY(said->isVisible());
}

void TestCharts::whatChangesOftenIsDrawnOnce()
{
    const auto* view = m_panel->findChild<QChartView*>();
    QCoreApplication::sendPostedEvents();
    const QChart* const before = view->chart();
    m_panel->setChart(bars());
    m_panel->setChart(histogram());
    m_panel->setChart(bars());
    QCOMPARE(view->chart(), before);
    QCoreApplication::sendPostedEvents();
    QVERIFY(view->chart() != before);
    const QChart* const drawn = view->chart();
    QCOMPARE(namesDrawn().size(), stopsOf(bars()).size());
    QCoreApplication::processEvents();
    QCOMPARE(view->chart(), drawn);
    // Who is quicker than the drawing meets what there is to be.
    m_panel->setChart(curve());
    QTest::keyClick(m_panel.get(), Qt::Key_Home);
    QCOMPARE(m_panel->said(), QString("Attempt 1: 48.5 points"));
    QVERIFY(view->chart() != drawn);
}

void TestCharts::whatIsHiddenIsDrawnWhenItIsShown()
{
    const auto* view = m_panel->findChild<QChartView*>();
    QCoreApplication::processEvents();
    m_panel->hide();
    const QChart* const before = view->chart();
    m_panel->setChart(bars());
    QCoreApplication::processEvents();
    QCOMPARE(view->chart(), before);
    m_panel->show();
    QTRY_COMPARE(namesDrawn().size(), stopsOf(bars()).size());
}

void TestCharts::theSameOnceMoreLeavesWhatIsTold()
{
    const auto* view = m_panel->findChild<QChartView*>();
    QTest::keyClick(m_panel.get(), Qt::Key_End);
    QCoreApplication::processEvents();
    const QChart* const drawn = view->chart();
    m_panel->setChart(curve());
    QCoreApplication::processEvents();
    QCOMPARE(view->chart(), drawn);
    QCOMPARE(m_panel->said(), QString("Attempt 6: 91 points"));
}

QTEST_MAIN(TestCharts)
#include "tst_charts.moc"
