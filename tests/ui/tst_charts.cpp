// SPDX-License-Identifier: GPL-3.0-or-later
// Charts describe their values in words, and can be exported as pictures and tables.
#include <QAction>
#include <QApplication>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QImage>
#include <QLabel>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include <memory>

#include "tests/support/Files.h"
#include "tests/support/FullDisk.h"
#include "tests/support/Suite.h"
#include "ui/charts/ChartPanel.h"
#include "ui/charts/SaveButton.h"
#include "ui/charts/Table.h"
#include "ui/kit/Theme.h"

using namespace ui::charts;

namespace {

Chart curve()
{
    Curve made;
    made.x = {"Attempt", 0.5, 6.5, true};
    made.y = {"Points", 0.0, 100.0};
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
    made.value = {"Points lost", 0.0, 30.0};
    made.nameTitle = "Criterion";
    made.bars = {{"Depth of the pulpal floor against the ideal", 24.0, "Depth: 24.0 points lost"},
                 {"Walls", 6.0, "Walls: 6.0 points lost"},
                 {"=cmd|' /C calc'!A0", 1.5, "Odd: 1.5"}};
    return {"What cost points", {}, "Nothing yet", made};
}

Chart histogram()
{
    Histogram made;
    made.x = {"Points", 0.0, 100.0};
    made.count = {"Students", 0.0, 10.0, true};
    for (int k = 0; k < 10; ++k)
        made.bins << Histogram::Bin{10.0 * k, 10.0 * (k + 1), k, QString("%1 students").arg(k)};
    made.limits = {{75.0, true, "Pass mark"}};
    return {"Best scores", "45 people", "Nothing yet", made};
}

/// Returns a chart with all marks and strokes on logarithmic axes, with a note at each dot.
Chart logarithmic()
{
    Curve made;
    made.x = {"Time", 1.0, 2000.0, false, 10.0};
    made.y = {"Error", 0.1, 1000.0, false, 10.0};
    made.limits = {{50.0, false, "noticed"}, {1000.0, true, "too late"}};
    const QList<Mark> marks{Mark::Circle, Mark::Square, Mark::Triangle, Mark::Diamond, Mark::Pentagon};
    for (int k = 0; k < marks.size(); ++k) {
        Line line{QString("method %1").arg(k), {}, marks[k], true, {}, static_cast<Qt::PenStyle>(k + 1)};
        for (int n = 0; n < 3; ++n)
            line.dots << Dot{3.0 + 40.0 * n, 2.0 * (k + 1) + 30 * n, {}, 0, {}, QString("note %1").arg(n)};
        made.lines << line;
    }
    return {"Logarithmic", {}, {}, made};
}

Chart map()
{
    Map made;
    made.groups = QStringList{"first", "second"};
    made.columns = QStringList{"0", "1"};
    made.columnTitle = "delay";
    for (int row = 0; row < 19; ++row) {
        made.rows << QString("scene %1").arg(row);
        made.cells << QList<Map::Cell>{
            {"#DDEDEA", "h", {}}, {"#A33A00", "D", "3/12"}, {"#DDEDEA", "h", {}}, {"#F5E6A3", {}, "7"}};
    }
    return {"Map", {}, {}, made};
}

template <class Fits>
int dots(const QImage& picture, const Fits& fits)
{
    int count = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            count += fits(picture.pixelColor(x, y)) ? 1 : 0;
    return count;
}

Chart named(const QStringList& names)
{
    Bars made;
    made.value = {"Points lost", 0.0, 30.0};
    for (const QString& name : names)
        made.bars << Bars::Bar{name, 2.0, {}};
    return {"What cost points", {}, {}, made};
}

}  // namespace

class TestCharts : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase() { QLocale::setDefault(QLocale("en_GB")); }

    void init()
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

    void arrowsWalkFromValueToValue()
    {
        QVERIFY(!m_panel->stop());
        const auto press = [this](Qt::Key key) {
            QTest::keyClick(m_panel.get(), key);
            return m_panel->said();
        };
        QCOMPARE(press(Qt::Key_Right), QString("Attempt 1: 48.5 points"));
        QCOMPARE(m_panel->accessibleDescription(), m_panel->said());
        QCOMPARE(press(Qt::Key_Right), QString("Attempt 2: 57 points"));
        for (const Qt::Key key : {Qt::Key_Home, Qt::Key_Left})
            QCOMPARE(press(key), QString("Attempt 1: 48.5 points"));
        QVERIFY(callout()->isVisible() && m_panel->rect().contains(callout()->geometry()));
        for (const Qt::Key key : {Qt::Key_End, Qt::Key_Right})
            QCOMPARE(press(key), QString("Attempt 6: 91 points"));
        m_panel->setChart(curve());  // the same chart again
        QCOMPARE(m_panel->said(), QString("Attempt 6: 91 points"));
        // If a chart has a band and no lines, the arrow keys step through the band.
        Chart band = curve();
        std::get<Curve>(band.content).lines.clear();
        m_panel->setChart(band);
        QCOMPARE(press(Qt::Key_Home), QString("class 1"));
    }

    /// Bars can be hit at any length, columns at any height.
    void thePointerFindsEveryValue()
    {
        for (const Chart& chart : {curve(), bars(), histogram()}) {
            m_panel->setChart(chart);
            QCoreApplication::processEvents();
            auto* view = m_panel->findChild<QWidget*>("chartView");
            QSet<QString> told;
            for (int y = 0; y < view->height(); y += 6)
                for (int x = 0; x < view->width(); x += 6) {
                    QMouseEvent move(QEvent::MouseMove, QPointF(x, y), view->mapToGlobal(QPointF(x, y)), Qt::NoButton,
                                     Qt::NoButton, Qt::NoModifier);
                    QApplication::sendEvent(view, &move);
                    told << m_panel->said();
                }
            told.remove({});
            QVERIFY2(told.size() == stopsOf(chart).size(), qPrintable(chart.title));
        }
    }

    void enterOpensWhatAValueStandsFor()
    {
        QSignalSpy chosen(m_panel.get(), &ChartPanel::chosen);
        QTest::keyClick(m_panel.get(), Qt::Key_Return);
        QCOMPARE(chosen.count(), 0);
        QTest::keyClick(m_panel.get(), Qt::Key_Home);
        QTest::keyClick(m_panel.get(), Qt::Key_Return);
        QCOMPARE(chosen.count(), 1);
        QCOMPARE(chosen.front().front().toLongLong(), 101);
    }

    void withoutValuesItSaysWhatWillBeHere()
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

    void tablesAreSafeForSpreadsheets()
    {
        for (const auto& [words, written] :
             {std::pair("Depth", "Depth"),
              {"a,b", "\"a,b\""},
              {"a\"b", "\"a\"\"b\""},
              {"a\nb", "\"a\nb\""},
              {"Höhe", "Höhe"},
              {"=1+1", "'=1+1"},
              {"+1", "'+1"},
              {"-1", "'-1"},
              {"@SUM(A1)", "'@SUM(A1)"},
              {"\t=1", "'\t=1"},
              {" =1", "' =1"},
              {"=HYPERLINK(\"http://x\",\"y\")", "\"'=HYPERLINK(\"\"http://x\"\",\"\"y\"\")\""},
              {"＝1", "'＝1"}})
            QCOMPARE(csv({{"head"}, {{QString(words)}}}), "head\r\n" + QByteArray(written) + "\r\n");
    }

    void numbersOfTablesKnowNoLanguage()
    {
        QLocale::setDefault(QLocale("de_DE"));
        // The rounding error of a sum is not exported.
        QCOMPARE(csv({{"a"}, {{0.1 + 0.2}}}), "a\r\n0.3\r\n");
        const QByteArray text = csv({{"a", "b", "c"}, {{-1234.5, std::int64_t{-1234567}, qQNaN()}}});
        QLocale::setDefault(QLocale("en_GB"));
        QCOMPARE(text, QByteArray("a,b,c\r\n-1234.5,-1234567,\r\n"));
    }

    void aChartIsATable()
    {
        const Table table = tableOf(curve());
        QCOMPARE(table.heads, QStringList({"series", "Attempt", "Points"}));
        QCOMPARE(table.rows.size(), 6 + 3 * 6 + 1);
        const Table lost = tableOf(bars());
        QCOMPARE(lost.rows.size(), 3);
        QVERIFY(csv(lost).contains("'=cmd"));
    }

    void everySeriesOfATableHasAName()
    {
        Chart chart = curve();
        auto& content = std::get<Curve>(chart.content);
        content.lines = {Line{{}, {Dot{1.0, 48.5, {}, 0}}, Mark::Circle, false}};
        QVERIFY(!csv(tableOf(chart)).contains("\r\n,"));  // the band already has these values
        QVERIFY(!csv(tableOf(chart)).contains("48.5"));
        content.band = {};
        QVERIFY(csv(tableOf(chart)).contains("\r\nPoints,1,48.5\r\n"));
    }

    void filesAreWritten()
    {
        const QTemporaryDir folder;
        const auto written = [&](const QString& name) {
            const QString path = folder.filePath(name);
            return save(path) ? QByteArray::fromStdString(support::bytesOf(path.toStdString())) : QByteArray();
        };
        QCOMPARE(QImage::fromData(written("chart.png")).size(), QSize(1920, 1200));
        const QByteArray drawing = written("chart.svg");
        QXmlStreamReader reader(drawing);
        while (!reader.atEnd())
            reader.readNext();
        QVERIFY(!reader.hasError() && drawing.contains("Score over attempts"));
        QCOMPARE(written("chart.csv"), csv(tableOf(curve())));
        // The message about the file stays until a value is shown.
        QVERIFY(callout()->isVisible());
        QCOMPARE(callout()->text(), QString("Saved: chart.csv"));
        QTest::keyClick(m_panel.get(), Qt::Key_Home);
        QCOMPARE(callout()->text(), m_panel->said());
        m_panel->setStop({});
        QVERIFY(!callout()->isVisible());
    }

    void whatCannotBeWrittenIsSaid()
    {
        QVERIFY(!save("/nowhere/at/all/chart.png"));
        QVERIFY(callout()->text().startsWith("chart.png could not be written"));
        const QTemporaryDir folder;
        const QString file = folder.filePath("small.csv");
        {
            const support::FullDisk full(10);
            QVERIFY(!save(file));
        }
        QVERIFY(!QFile::exists(file));
        QVERIFY(callout()->text().startsWith("small.csv could not be written"));
    }

    /// The marks of the first line are drawn in the colour of the theme.
    void picturesShowSomethingInBothThemes()
    {
        for (const auto theme : {ui::kit::ThemeChoice::Light, ui::kit::ThemeChoice::Dark})
            for (const Chart& chart : {curve(), bars(), histogram()}) {
                ui::kit::applyTheme(*qApp, theme);
                m_panel->setChart(chart);
                m_panel->setStop(1);
                const QColor accent = ui::kit::tones(m_panel->palette()).accent;
                QVERIFY2(dots(m_panel->grab().toImage(), [&](const QColor& one) { return one == accent; }) > 40,
                         qPrintable(chart.title));
            }
    }

    void everythingIsDrawn_data()
    {
        QTest::addColumn<Chart>("chart");
        QTest::addColumn<QStringList>("words");
        QTest::newRow("curve")
            << curve()
            << QStringList{
                   "Score over attempts",      "23 people", "Attempt",   "Points", "Score", "Passed", "Not passed",
                   "Middle half of the class", "Median",    "Pass mark", "6",      "100"};
        QTest::newRow("columns") << histogram() << QStringList{"Points", "Students", "Pass mark", "0", "80", "10"};
        QTest::newRow("bars") << bars() << QStringList{"Points lost", "Walls", "30"};
        QTest::newRow("logarithmic") << logarithmic()
                                     << QStringList{"0.1",    "1000",   "noticed", "too late", "method 0", "method 4",
                                                    "note 0", "note 1", "note 2",  "Time",     "Error"};
        QTest::newRow("map") << map()
                             << QStringList{"scene 0", "scene 18", "first", "second", "delay", "D", "3/12", "7"};
        Chart labelled = logarithmic();
        std::get<Curve>(labelled.content).x = {"Grid", -0.2, 150.0, false, 0.0, {"small", "large"}};
        QTest::newRow("labels") << labelled << QStringList{"Grid", "small", "large"};
    }

    /// Checks the words of the drawing. Pictures must have ink where the drawing has lines, and none at their edges.
    void everythingIsDrawn()
    {
        QFETCH(Chart, chart);
        QFETCH(QStringList, words);
        const QString drawing = QString::fromUtf8(svg(chart));
        for (const QString& word : words)
            QVERIFY2(drawing.contains(">" + word + "<"), qPrintable(word));
        QVERIFY(!drawing.contains("nan") && !drawing.contains("inf"));
        const QImage picture = QImage::fromData(png(chart));
        QCOMPARE(picture.size(), QSize(1920, 1200));
        const auto isInk = [](const QColor& one) { return one != Qt::white; };
        const int inked = dots(picture, isInk);
        QVERIFY(inked > 5000);
        QCOMPARE(dots(picture.copy(picture.rect().adjusted(7, 7, -7, -7)), isInk), inked);
    }

    void valuesLieWhereTheirAxesSay()
    {
        Plot plot = plotOf(logarithmic(), {0.0, 0.0, 500.0, 400.0});
        QCOMPARE(plot.at(1.0, 0.1), plot.px.bottomLeft());
        QCOMPARE(plot.at(2000.0, 1000.0), plot.px.topRight());
        QCOMPARE(plot.at(1.0, 10.0).y(), plot.px.center().y());  // half of four decades
        QCOMPARE(plot.xAt(plot.at(30.0, 1.0).x()), 30.0);
        plot = plotOf(histogram(), {0.0, 0.0, 500.0, 400.0});
        QCOMPARE(plot.at(50.0, 5.0), plot.px.center());
        // A mark on the edge is visible completely.
        Chart edge = curve();
        std::get<Curve>(edge.content).lines[1].dots[0].y = 100.0;
        plot = plotOf(edge, {0.0, 0.0, 500.0, 400.0});
        QVERIFY(plot.at(5.0, 100.0).y() > plot.px.top() + 4.0);
    }

    void axesEndAtRoundNumbers()
    {
        for (const auto& [value, end] :
             {std::pair(0.0, 1.0), {1.0, 1.0}, {1.2, 2.0}, {22.0, 25.0}, {0.3, 0.5}, {6100.0, 10000.0}})
            QCOMPARE(roundEnd(value), end);
    }

    void aFileSaysWhoseItIs()
    {
        Chart mine = histogram();
        mine.of = "Year 1, Decay on 36";
        const QByteArray told = svg(mine);
        QVERIFY(told.contains("Year 1, Decay on 36"));
        QVERIFY(told != svg(histogram()));
        m_panel->setChart(mine);
        QVERIFY(!m_panel->findChild<QLabel*>("chartTitle")->text().contains("Year"));  // the page itself names it
        m_panel->findChild<QAction*>("saveCSV")->trigger();
        auto* dialog = m_panel->findChild<QFileDialog*>();
        QVERIFY(dialog != nullptr);
        QCOMPARE(QFileInfo(dialog->selectedFiles().front()).fileName(),
                 QString("Best scores, Year 1, Decay on 36.csv"));
        dialog->reject();
    }

    void namesAreFoldedWhereThereIsRoom()
    {
        const QString name = "Gesunde Substanz neben der Karies entfernt";
        const QString japanese = "う蝕の隣の健全な歯質を削除した量と深さと幅";
        const Chart five = named({name, japanese, "Walls", "Depth", "Floor"});
        const auto namesIn = [&](const QSizeF& room) { return namesOf(std::get<Bars>(five.content), room); };
        const QStringList folded = namesIn({450.0, 290.0});
        QCOMPARE(folded[0].simplified(), name);
        QCOMPARE(folded[0].count('\n'), 1);
        QCOMPARE(QString(folded[1]).remove('\n'), japanese);  // it has no spaces at which it could break
        // If there is room for one line only, the beginning and the end are shown.
        const QString cut = namesIn({450.0, 150.0})[0];
        QVERIFY2(cut.contains(u'…') && cut.startsWith("Ges") && cut.endsWith("fernt") && !cut.contains('\n'),
                 qPrintable(cut));
        QCOMPARE(namesIn({900.0, 500.0})[0], name);
    }

    void barsWithoutRoomAreCounted()
    {
        const QString name = "Gesunde Substanz neben der Karies entfernt";
        QVERIFY(rowsFor(named(QStringList(5, name)), {300.0, 160.0}) >= 5);  // a short name is better than no bar
        const Chart many = named(QStringList(20, name));
        QVERIFY(rowsFor(many, {300.0, 160.0}) < 5);
        const auto shown = std::get<Bars>(fitted(many, 4).content).bars;
        QCOMPARE(shown.size(), 4);
        QCOMPARE(shown.back().name, QString("and 17 more"));
        // The panel shows as many values as there is room for.
        m_panel->setChart(many);
        const auto stops = [this] {
            QTest::keyClick(m_panel.get(), Qt::Key_End);
            return m_panel->stop().value();
        };
        const qsizetype before = stops();
        m_panel->resize(900, 900);
        QTRY_VERIFY(stops() > before);
    }

private:
    [[nodiscard]] bool save(const QString& path) { return m_panel->findChild<SaveButton*>()->save(path); }
    [[nodiscard]] QLabel* callout() { return m_panel->findChild<QLabel*>("chartCallout"); }

    std::unique_ptr<ChartPanel> m_panel;
};

CUSP_TEST(TestCharts)
#include "tst_charts.moc"
