// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCheckBox>
#include <QHelpEvent>
#include <QProgressBar>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QToolTip>

#include <cmath>
#include <map>
#include <set>

#include "core/servo/ServoState.h"
#include "tests/support/Checks.h"
#include "tests/support/Files.h"
#include "tests/support/Suite.h"
#include "tests/ui/PageTest.h"
#include "tests/ui/WindowTest.h"
#include "ui/charts/SaveButton.h"
#include "ui/kit/ScrollPane.h"
#include "ui/scoring/CommentsPanel.h"
#include "ui/scoring/CriterionRow.h"
#include "ui/scoring/HeatMap.h"
#include "ui/scoring/RecentScoresChart.h"
#include "ui/scoring/ScorePage.h"
#include "ui/text/Texts.h"

using lessons::Moment;
using ui::scoring::CriterionRow;
using ui::scoring::HeatMap;
using ui::scoring::ScoredWork;
using ui::scoring::ScorePage;

namespace {

/// A tooth cut to the ideal with two errors: a pit 0.4 mm too deep at one place of the floor, and an uncut area at the
/// other end.
struct Faulty
{
    lessons::Assignment assignment;
    ScoredWork work;
    lessons::ScoreSheet sheet;
};

/// Returns the tooth for a lesson, made once for each lesson.
const Faulty& faulty(const std::string& id)
{
    static std::map<std::string, Faulty> all;
    if (const auto found = all.find(id); found != all.end())
        return found->second;
    Faulty& made = all[id];
    made.assignment = support::assigned(id);
    const core::terrain::ToothAnatomy& anatomy = *made.assignment.anatomy;
    made.work.ideal = made.assignment.shownIdeal();
    std::vector<float> top = *made.work.ideal;
    std::vector<std::pair<double, std::size_t>> cut;  // from left to right
    for (int j = 0; j < anatomy.grid.side; ++j)
        for (int i = 0; i < anatomy.grid.side; ++i)
            if (const std::size_t k = anatomy.grid.index(i, j); top[k] < anatomy.top[k])
                cut.emplace_back(anatomy.grid.nodeMm(i, j).x, k);
    std::sort(cut.begin(), cut.end());
    for (std::size_t n = 0; n < cut.size() / 4; ++n) {
        top[cut[n].second] -= 0.4F;
        const std::size_t untouched = cut[cut.size() - 1 - n].second;
        top[untouched] = anatomy.top[untouched];
    }
    auto tooth = core::terrain::restored(made.assignment.anatomy, top);
    const auto marked = lessons::mark(made.assignment, tooth).value();
    made.work.tooth = std::make_shared<const core::terrain::Tooth>(std::move(tooth));
    made.work.measured = marked.measured;
    made.sheet = marked.sheet;
    return made;
}

QList<database::AttemptRecord> attempts(const lessons::ScoreSheet& sheet)
{
    database::AttemptRecord now;
    now.scoreTenths = sheet.totalTenths;
    now.finishedUtc = "2026-11-20T10:15:00Z";
    now.rubricHash = sheet.rubricHash;
    database::AttemptRecord old = now;
    old.scoreTenths = 612;
    old.rubricHash = "another";
    return {now, old};
}

core::grading::Process conducted()
{
    core::grading::Process process;
    process.totalS = 133.0;
    process.cuttingS = 62.0;
    process.undos = 3;
    return process;
}

/// Splits each criterion's loss into five parts, the first of which was never earned.
std::vector<std::vector<Moment>> parts(const lessons::ScoreSheet& sheet)
{
    std::vector<std::vector<Moment>> made;
    for (const lessons::Criterion& line : sheet.criteria) {
        made.emplace_back();
        int left = line.lostTenths;
        for (int n = 0; n < 5 && left > 0; ++n) {
            const int part = n == 4 ? left : std::min(left, 3 + 2 * n);
            left -= part;
            made.back().push_back(
                n == 0 ? Moment{Moment::Kind::Never, part, 90000, 90.0, 0}
                       : Moment{Moment::Kind::Stroke, part, 1000U * 16U * static_cast<unsigned>(n), 16.0 * n, 4 * n});
        }
    }
    return made;
}

}  // namespace

class TestScorePage : public support::PageTest<ScorePage>
{
    Q_OBJECT

private slots:
    void initTestCase() { prepare(); }
    void init() { openPage(); }

    void tooDeepAndStillToGoAreTold()
    {
        const Faulty& made = faulty("class1-36");
        int deep = 0;
        int left = 0;
        for (std::size_t k = 0; k < made.work.tooth->top.size(); ++k) {
            const float above = ui::scoring::aboveIdeal(made.work, k);
            deep += std::abs(above + 0.4F) < 0.001F ? 1 : 0;
            left += above > 0.05F ? 1 : 0;
            QVERIFY(above > -0.401F);
        }
        QVERIFY(deep > 100 && left > 100);
        const auto farthest = ui::scoring::farthestOff(made.work);
        QVERIFY(farthest && ui::scoring::aboveIdeal(made.work, *farthest) > 0.4F);
        for (const double mm : {0.1, 0.5, 1.0, 3.0}) {
            const QColor tooDeep(ui::scoring::heatColour(-mm));
            const QColor toGo(ui::scoring::heatColour(mm));
            QVERIFY(tooDeep.red() > tooDeep.blue() + 20);
            QVERIFY(toGo.blue() > toGo.red() + 20);
        }
        // A deeper error is darker, up to the end of the scale.
        QVERIFY(QColor(ui::scoring::heatColour(-0.2)).lightness() > QColor(ui::scoring::heatColour(-0.8)).lightness());
        QCOMPARE(ui::scoring::heatColour(-1.0), ui::scoring::heatColour(-2.0));
    }

    void aCriterionShowsItsOwnWorstPlace()
    {
        const Faulty& made = faulty("class1-36");
        show(made);
        const auto* heat = child<HeatMap>();
        int places = 0;
        std::set<std::size_t> nodes;
        for (CriterionRow* row : rows()) {
            QTest::mouseClick(row, Qt::LeftButton, {}, {8, 8});
            QVERIFY(row->isChecked());
            const auto own = core::grading::findMeasure(row->criterion().measure)->nodeIn(made.work.measured);
            if (own) {
                ++places;
                nodes.insert(*own);
                QCOMPARE(heat->marked(), own);
                QVERIFY2(textOf("place").contains(ui::text::criterionName(row->criterion())),
                         qPrintable(textOf("place")));
                // Beside a wall or a ridge, the depth of the cut is not the error.
                const std::string& measure = row->criterion().measure;
                const bool isAcross = measure.starts_with("ridge") || measure.starts_with("wall");
                QVERIFY2(!isAcross || !textOf("place").contains(" mm "), qPrintable(textOf("place")));
            } else {
                QCOMPARE(heat->marked(), ui::scoring::farthestOff(made.work));
            }
            if (row->criterion().lostTenths == 0)
                QVERIFY2(textOf("place").contains("no points lost"), qPrintable(textOf("place")));
            else
                QVERIFY2(own || textOf("place").contains("no place"), qPrintable(textOf("place")));
        }
        QVERIFY(places >= 5 && nodes.size() >= 3);
    }

    void rowsStayWhereTheyAre()
    {
        show(faulty("class1-36"));
        const auto rows = m_page->findChildren<CriterionRow*>();
        const auto places = [&] {
            QApplication::processEvents();
            QList<QRect> all;
            for (const CriterionRow* row : rows)
                all << row->geometry();
            return all;
        };
        for (const bool detailed : {false, true}) {
            child<QToolButton>("scoreDetails")->setChecked(detailed);
            const QList<QRect> before = places();
            for (CriterionRow* row : rows) {
                row->click();
                QVERIFY(row->isChecked());
                QCOMPARE(places(), before);
            }
        }
    }

    void whatCannotBeShownIsPlainText()
    {
        Faulty made = faulty("decay-36-moderate");
        show(made);
        const auto* row = child<CriterionRow>("criterion_caries_left");
        for (QPushButton* chip : row->findChildren<QPushButton*>())
            QVERIFY(!chip->text().contains("not removed"));
        QCOMPARE(row->focusPolicy(), Qt::StrongFocus);
        QCOMPARE(row->cursor().shape(), Qt::PointingHandCursor);
        // Without a recording there is no tooth on which a place could be shown.
        m_page->setScore([] { return QString(); }, made.sheet, {}, {}, {});
        for (const CriterionRow* plain : m_page->findChildren<CriterionRow*>()) {
            QVERIFY(!plain->isChecked());
            QCOMPARE(plain->focusPolicy(), Qt::NoFocus);
            QCOMPARE(plain->cursor().shape(), Qt::ArrowCursor);
        }
    }

    /// A pulp that was not opened was not cut too deep, even if other tissue was.
    void whatCostNothingIsNotTooDeep()
    {
        Faulty made = faulty("decay-36-moderate");
        made.sheet.criteria.resize(1);
        lessons::Criterion& pulp = made.sheet.criteria.front();
        pulp.measure = "pulp_exposed_mm2";
        pulp.measured = 0.0;
        pulp.share = pulp.error = 0.0;
        pulp.lostTenths = 0;
        show(made);
        QVERIFY2(textOf("place").contains("no points lost"), qPrintable(textOf("place")));
        pulp.measured = pulp.share = 1.0;
        show(made);
        QVERIFY2(textOf("place").contains(" mm "), qPrintable(textOf("place")));
    }

    void aMomentLeadsThere()
    {
        const Faulty& made = faulty("decay-36-moderate");
        show(made);
        QSignalSpy wanted(m_page, &ScorePage::momentRequested);
        const auto* row = child<CriterionRow>("criterion_caries_left");
        const auto chips = row->findChildren<QPushButton*>();
        QCOMPARE(chips.size(), 3);
        QVERIFY2(chips[0]->text().contains("at 0:") && chips[0]->text().contains("stroke"),
                 qPrintable(chips[0]->text()));
        for (QPushButton* chip : chips)
            if (chip->text().contains("stroke 12"))
                chip->click();
        QCOMPARE(wanted.count(), 1);
        QCOMPARE(wanted.front().front().toDouble(), 48.0);
        // The remaining moments are collapsed.
        QVERIFY2(chips.back()->text().contains("3"), qPrintable(chips.back()->text()));
        chips.back()->click();
        QTRY_COMPARE(row->findChildren<QPushButton*>().size(), 4);
        const auto words = row->findChildren<QLabel*>();
        QVERIFY(std::any_of(words.begin(), words.end(),
                            [](const QLabel* label) { return label->text().contains("not removed"); }));
        m_page->setMomentsProgress(0.4);
        QVERIFY(child<QProgressBar>()->isVisible());
        QCOMPARE(child<QProgressBar>()->value(), 40);
        m_page->setMoments(parts(made.sheet));
        QVERIFY(!child<QProgressBar>()->isVisible());
    }

    void neighboursAreReadAsOne()
    {
        using Kind = Moment::Kind;
        const std::vector<Moment> read = ui::scoring::asRead({{Kind::Stroke, 3, 1000, 1.0, 1},
                                                              {Kind::Stroke, 2, 2000, 2.0, 1},
                                                              {Kind::Stroke, 4, 12000, 12.0, 1},
                                                              {Kind::Stroke, 5, 13000, 13.0, 2},
                                                              {Kind::Way, 1, 14000, 14.0, 0},
                                                              {Kind::Way, 1, 15000, 15.0, 0}});
        QCOMPARE(read, (std::vector<Moment>{{Kind::Stroke, 5, 1000, 1.0, 1},
                                            {Kind::Stroke, 4, 12000, 12.0, 1},
                                            {Kind::Stroke, 5, 13000, 13.0, 2},
                                            {Kind::Way, 2, 14000, 14.0, 0}}));
    }

    void theAdviceComesFirstAndLeadsToItsMoment()
    {
        Faulty made = faulty("class1-36");
        m_page->setScore([] { return QString(); }, made.sheet, {}, {}, made.work);
        const auto* advice = child<QLabel>("advice");
        auto* button = child<QPushButton>("showMoment");
        QVERIFY(advice->isVisible() && !advice->text().isEmpty());
        QVERIFY(!button->isVisible());  // the moments are not known yet
        m_page->setMoments(parts(made.sheet));
        QVERIFY(button->isVisible());
        // The row with the largest loss is selected, and its place shows the same advice.
        QCOMPARE(textOf("placeAdvice"), advice->text());
        QSignalSpy wanted(m_page, &ScorePage::momentRequested);
        button->click();
        QCOMPARE(wanted.count(), 1);
        QCOMPARE(wanted.front().front().toDouble(), 64.0);
    }

    void sumsAreFoldedAway()
    {
        show(faulty("class1-36"));
        auto* details = child<QToolButton>("scoreDetails");
        for (const char* name : {"sum", "rubric"})
            QVERIFY(!child<QLabel>(name)->isVisible());
        details->click();
        for (const char* name : {"sum", "rubric"})
            QVERIFY(child<QLabel>(name)->isVisible());
        QVERIFY(child<QLabel>("worked_depth")->isVisible());
        details->click();
        QVERIFY(!child<QLabel>("sum")->isVisible() && !child<QLabel>("worked_depth")->isVisible());
    }

    void aLimitThatTookNothingIsADetail()
    {
        Faulty made = faulty("class1-36");
        const auto limit = [&](const char* id) -> lessons::Criterion& {
            return *std::find_if(made.sheet.criteria.begin(), made.sheet.criteria.end(),
                                 [id](const lessons::Criterion& one) { return one.id == id; });
        };
        limit("thin").lostTenths = 0;
        limit("in_enamel").lostTenths = 120;
        show(made);
        const auto isShown = [this](const char* name) { return child<CriterionRow>(name)->isVisible(); };
        QVERIFY(!isShown("criterion_thin") && isShown("criterion_in_enamel"));
        QVERIFY(!isShown("criterion_pulp_exposure") && isShown("criterion_depth"));
        // The arrow keys skip hidden rows.
        auto* last = child<CriterionRow>("criterion_floor");
        last->setFocus();
        QTest::keyClick(last, Qt::Key_Down);
        QVERIFY(!QApplication::focusWidget()->isHidden() && QApplication::focusWidget() != last);
        child<QToolButton>("scoreDetails")->click();
        QVERIFY(isShown("criterion_thin"));
        child<QToolButton>("scoreDetails")->click();
    }

    void breachesLeadToTheirMoments()
    {
        using core::grading::RuleViolation;
        Faulty made = faulty("decay-36-moderate");
        show(made);
        const auto* facts = child<QLabel>("conduct");
        QVERIFY(!facts->isVisible());  // there is no record of the process
        made.work.measured.process = conducted();
        show(made);
        QVERIFY(textOf("breaches").contains("No breach"));
        QVERIFY2(facts->text().contains("2:13") && facts->text().contains("1:02") && facts->text().contains("3 step") &&
                     facts->text().contains("No aid"),
                 qPrintable(facts->text()));
        made.work.aids = core::servo::kSectionAid;
        for (int n = 0; n < 7; ++n)
            made.work.infractions.push_back({n == 5 ? RuleViolation::PulpExposed : RuleViolation::BurInAir,
                                             static_cast<std::uint64_t>(1000 * n),
                                             20.0 * n,
                                             {},
                                             0,
                                             20});
        show(made);
        QVERIFY(facts->text().contains("section"));
        QVERIFY(textOf("breaches").contains("7"));
        const auto chips = [&] { return facts->parentWidget()->findChildren<QPushButton*>(); };
        QCOMPARE(chips().size(), 2);
        QPushButton* pulp = nullptr;
        for (QPushButton* chip : chips())
            if (chip->text().contains("pulp"))
                pulp = chip;
        QVERIFY(pulp != nullptr);
        QSignalSpy wanted(m_page, &ScorePage::momentRequested);
        QTest::mouseClick(pulp, Qt::LeftButton);
        QCOMPARE(wanted.count(), 1);
        QCOMPARE(wanted.front().front().toDouble(), 100.0);
        QTest::mouseClick(chips().back(), Qt::LeftButton);
        QTRY_COMPARE(chips().size(), 7);
    }

    void padsAreToldWithTheirAnswers()
    {
        using core::terrain::Material;
        Faulty made = faulty("decay-36-moderate");
        made.sheet.criteria.resize(1);
        made.sheet.criteria.front().measure = "pads_named_percent";  // a measure without a place
        made.work.measured.practised = core::grading::Named{{Material::Enamel, Material::Caries, std::nullopt}, 1};
        show(made);
        QVERIFY2(textOf("place").contains("has no place"), qPrintable(textOf("place")));
        made.work.exercise = core::grading::PadsToName{{Material::Enamel, Material::Dentin, Material::Caries}};
        show(made);
        QCOMPARE(textOf("place"),
                 QString("Left: enamel, correct · Middle: dentin, your answer: decay · Right: decay, no answer"));
    }

    void aPointThatWasMissedIsShown()
    {
        Faulty made = faulty("decay-36-moderate");
        const core::terrain::Grid& grid = made.work.tooth->grid();
        const std::size_t missed = grid.index(grid.side / 3, grid.side / 2);
        made.sheet.criteria.resize(1);
        made.sheet.criteria.front().measure = "points_touched_percent";
        made.work.exercise = core::grading::PointsToTouch{{{0.0, 0.0}, grid.nodeMm(grid.side / 3, grid.side / 2)}, 0.6};
        made.work.measured.practised = core::grading::Touched{{12.5, std::nullopt}};
        show(made);
        QCOMPARE(textOf("place"), QString("1 of 2 points touched; the ring marks a missed point"));
        QCOMPARE(child<HeatMap>()->marked(), std::optional(missed));
        made.work.measured.practised = core::grading::Touched{{12.5, 20.0}};
        show(made);
        QCOMPARE(textOf("place"), QString("All points were touched"));
        made.sheet.criteria.front().measure = "hold_longest_s";
        made.work.exercise = core::grading::ForceToHold{};
        core::grading::Held held;
        held.longestS = 8.3;
        held.meanErrorN = 0.12;
        made.work.measured.practised = held;
        show(made);
        QCOMPARE(textOf("place"), QString("Held for 8.3 of 10 s, mean deviation 0.12 N"));
    }

    void itSaysWhenTheGridDecides()
    {
        m_page->setScore([] { return QString(); }, faulty("decay-36-moderate").sheet, {}, {}, {});
        child<QToolButton>("scoreDetails")->setChecked(true);
        QVERIFY(!child<QLabel>("noise")->isVisible());
        m_page->setNoise({{834, true}, {829, true}, {{836, true}}});
        const QString clear = textOf("noise");
        const QString scores = child<QLabel>("noise")->toolTip();
        QVERIFY2(scores.contains("82.9") && scores.contains("83.6"), qPrintable(scores));
        m_page->setNoise({{752, true}, {749, false}, {{753, true}}});
        QVERIFY2(textOf("noise") != clear, qPrintable(clear));
        QVERIFY(child<QLabel>("noise")->toolTip().contains("74.9"));
    }

    void otherRubricsAreShownApart()
    {
        const lessons::ScoreSheet& sheet = faulty("decay-36-moderate").sheet;
        m_page->setScore([] { return QString(); }, sheet, attempts(sheet), {}, {});
        auto* chart = child<ui::scoring::RecentScoresChart>();
        const QString spoken = chart->accessibleName();
        QVERIFY2(spoken.contains("61.2 with another rubric, " + ui::text::points(sheet.totalTenths)),
                 qPrintable(spoken));
        const auto labels = m_page->findChildren<QLabel*>();
        QCOMPARE(std::count_if(labels.begin(), labels.end(),
                               [](const QLabel* label) { return label->text() == "other rubric"; }),
                 1);
        // The tooltip has more details of a column, and a file has those of all columns.
        QHelpEvent onFirst(QEvent::ToolTip, {4, 40}, chart->mapToGlobal(QPoint(4, 40)));
        QApplication::sendEvent(chart, &onFirst);
        QVERIFY2(QToolTip::text().contains("2026") && QToolTip::text().contains("61.2 with another rubric"),
                 qPrintable(QToolTip::text()));
        const QTemporaryDir folder;
        auto* save = child<ui::charts::SaveButton>();
        QVERIFY(save->isVisible() && save->save(folder.filePath("scores.csv")));
        const std::string table = support::bytesOf(folder.filePath("scores.csv").toStdString());
        QVERIFY2(table.find("61.2") != std::string::npos, table.c_str());
        m_page->setHistory({});
        QVERIFY(!save->isVisible());  // there is nothing to save
    }

    void aClassOfFewIsNotShown()
    {
        m_page->setScore([] { return QString(); }, faulty("decay-36-moderate").sheet, {}, {}, {});
        QVERIFY(!child<QLabel>("class")->isVisible());
        m_page->setClass({4, {}});
        QVERIFY2(textOf("class").contains("needs 5 people"), qPrintable(textOf("class")));
        QVERIFY(!textOf("class").contains("%"));
        m_page->setClass({12, 41.7});
        QVERIFY2(textOf("class").contains("42 % are below"), qPrintable(textOf("class")));
    }

    void theFirstViewNeedsNoScrolling()
    {
        m_page->resize(1280, 760);  // a screen of 1280 x 800 with a task bar
        Faulty made = faulty("decay-36-moderate");
        made.work.measured.process = conducted();
        made.work.aids = core::servo::kSectionAid | core::servo::kIdealAid | core::servo::kRadiographAid;
        for (int n = 0; n < 9; ++n)
            made.work.infractions.push_back(
                {core::grading::RuleViolation::BurInAir, static_cast<std::uint64_t>(1000 * n), 20.0 * n, {}, 0, 20});
        show(made);
        const auto* pane = child<ui::kit::ScrollPane>();
        QTRY_VERIFY2(!pane->hasMoreBelow(),
                     qPrintable(QString("%1 px too high").arg(pane->verticalScrollBar()->maximum())));
    }

    void keysReachRowsAndMoments()
    {
        show(faulty("decay-36-moderate"));
        auto* first = child<CriterionRow>("criterion_caries_left");
        first->setFocus();
        QTest::keyClick(first, Qt::Key_Down);
        QVERIFY(child<CriterionRow>("criterion_sound_tissue")->isChecked());
        first->setFocus();
        QSet<QWidget*> reached;
        for (int k = 0; k < 40; ++k) {
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
            reached << QApplication::focusWidget();
        }
        for (QPushButton* chip : first->findChildren<QPushButton*>())
            QVERIFY2(reached.contains(chip), qPrintable(chip->text()));
    }

    void aPlaceIsPinnedAndFoundAgain()
    {
        const Faulty& made = faulty("class1-36");
        show(made);
        auto* heat = child<HeatMap>();
        auto* atPlace = child<QCheckBox>("atPlace");
        // A user who can only read cannot pin a place.
        m_page->setTalkVisible(true);
        QApplication::processEvents();
        QTest::mouseClick(heat, Qt::LeftButton, {}, heat->rect().center());
        QVERIFY(!heat->pin());
        m_page->setMayTalk(true);
        QTest::mouseClick(heat, Qt::LeftButton, {}, heat->rect().center());
        QVERIFY(heat->pin() && atPlace->isChecked());
        const core::terrain::Grid& grid = made.work.tooth->grid();
        const auto place = *heat->pin();
        const glm::dvec2 node = grid.latticeOf(glm::dvec2(place[0], place[1]));
        const auto k = grid.index(static_cast<int>(std::lround(node.x)), static_cast<int>(std::lround(node.y)));
        QCOMPARE(place[2], static_cast<double>(made.work.tooth->top[k]));  // on the final surface
        // A click beside the tooth is not a place.
        QTest::mouseClick(heat, Qt::LeftButton, {}, {4, 4});
        QVERIFY(!heat->pin() && !atPlace->isChecked());
        // The place of a comment is shown and scrolled into view.
        database::AttemptTalk talk;
        talk.comments.push_back({1, "Grace Hopper", "2026-11-20T10:00:00Z", "Here.", place, {}});
        m_page->talk().setTalk(talk);
        for (QPushButton* button : m_page->talk().findChildren<QPushButton*>())
            if (button->property("kind") == "chip")
                button->click();
        QCOMPARE(heat->pin(), std::optional(place));
        QVERIFY(!heat->visibleRegion().isEmpty());
        // Another score card begins without a pin.
        show(made);
        QVERIFY(!heat->pin());
    }

    void aPinMovesWithTheKeys()
    {
        const Faulty& made = faulty("class1-36");
        show(made);
        m_page->setTalkVisible(true);
        m_page->setMayTalk(true);
        auto* heat = child<HeatMap>();
        heat->setFocus();
        QTest::keyClick(heat, Qt::Key_Right);
        QVERIFY(heat->pin());  // it begins at the ring
        const auto before = *heat->pin();
        QTest::keyClick(heat, Qt::Key_Right, Qt::ShiftModifier);
        const double cell = made.work.tooth->grid().cellMm;
        QVERIFY(support::near((*heat->pin())[0] - before[0], cell));
        QTest::keyClick(heat, Qt::Key_Up);
        QVERIFY((*heat->pin())[1] > before[1]);
        QTest::keyClick(heat, Qt::Key_Delete);
        QVERIFY(!heat->pin());
        QVERIFY(!child<QCheckBox>("atPlace")->isChecked());
    }

    void whatWasSaidIsScrolledTo()
    {
        m_page->setTalkVisible(true);
        show(faulty("decay-36-moderate"));
        database::AttemptTalk talk;
        talk.comments.assign(8, {1, "Grace Hopper", "2026-11-20T10:00:00Z", "Here you pressed too hard.", {}, {}});
        m_page->talk().setTalk(talk);
        m_page->showTalk();
        auto* pane = child<ui::kit::ScrollPane>();
        QTRY_VERIFY(pane->verticalScrollBar()->value() > 0);
        const int top = m_page->talk().mapTo(pane->viewport(), QPoint(0, 0)).y();
        QVERIFY2(top >= 0 && top < pane->viewport()->height() / 2, qPrintable(QString::number(top)));
    }

    /// The page can be read with the keyboard: the focused control is scrolled into view, and the page keys scroll
    /// where no control can have the focus.
    void theKeyboardReadsAll()
    {
        m_page->resize(900, 600);
        show(faulty("decay-36-moderate"));
        m_page->setTalkVisible(true);
        database::AttemptTalk talk;
        talk.comments.push_back({1, "Grace Hopper", "2026-11-20T10:00:00Z", "Here.", {}, std::int64_t{45000}, false});
        talk.overrides.assign(20, {"Grace Hopper", "2026-11-20T10:00:00Z", 900, "Neat."});
        m_page->talk().setTalk(talk);
        auto* pane = child<ui::kit::ScrollPane>();
        QTRY_VERIFY(pane->verticalScrollBar()->maximum() > 0);
        pane->verticalScrollBar()->setValue(0);
        QPushButton* chip = nullptr;
        for (auto* button : m_page->talk().findChildren<QPushButton*>())
            if (button->accessibleName().startsWith("Show the moment"))
                chip = button;
        QVERIFY(chip != nullptr);
        chip->setFocus(Qt::TabFocusReason);
        const int bottom = chip->mapTo(pane->viewport(), QPoint(0, chip->height())).y();
        QVERIFY2(bottom > 0 && bottom <= pane->viewport()->height() - 36, qPrintable(QString::number(bottom)));
        const int before = pane->verticalScrollBar()->value();
        QTest::keyClick(chip, Qt::Key_PageDown);
        QVERIFY(pane->verticalScrollBar()->value() > before);
        QTest::keyClick(chip, Qt::Key_End);
        QCOMPARE(pane->verticalScrollBar()->value(), pane->verticalScrollBar()->maximum());
        QTest::keyClick(chip, Qt::Key_Home);
        QCOMPARE(pane->verticalScrollBar()->value(), 0);
        // This also works from a control below the pane.
        auto* beneath = child<QWidget>("scoreReport");
        QVERIFY(!pane->isAncestorOf(beneath));
        QTest::keyClick(beneath, Qt::Key_PageDown);
        QVERIFY(pane->verticalScrollBar()->value() > 0);
    }

    void theScoreThatATeacherGaveIsToldAndCompared()
    {
        show(faulty("class1-36"));
        QVERIFY2(textOf("sum").startsWith("100.0"), qPrintable(textOf("sum")));
        m_page->setGiven(800);
        QVERIFY2(textOf("sum").startsWith("Automatic score: 100.0"), qPrintable(textOf("sum")));
        QVERIFY2(textOf("expectation").startsWith("You expected 90.0 points. You overestimated by 10.0 points."),
                 qPrintable(textOf("expectation")));
    }

private:
    /// Returns the visible rows.
    [[nodiscard]] QList<CriterionRow*> rows() const
    {
        auto all = m_page->findChildren<CriterionRow*>();
        all.removeIf([](const CriterionRow* row) { return row->isHidden(); });
        return all;
    }
    void show(const Faulty& made)
    {
        const QList<database::AttemptRecord> past = attempts(made.sheet);
        m_page->setScore([] { return QStringLiteral("Class I, tooth 36"); }, made.sheet,
                         {past[0], past[0], past[0], past[1]}, ui::scoring::ScorePrediction{900, "depth"}, made.work);
        m_page->setMoments(parts(made.sheet));
        m_page->setClass({1, {}});
        m_page->setNoise(lessons::gridNoise(made.assignment, *made.work.tooth).value());
        // A layout takes several passes.
        const auto all = rows();
        QTRY_VERIFY(all.size() == 1 || all.back()->y() >= all.front()->y() + all.front()->height());
        QApplication::processEvents();
    }
};

CUSP_TEST(TestScorePage)
#include "tst_score_page.moc"
