// SPDX-License-Identifier: GPL-3.0-or-later
// A recording as the view receives it: at any time, in any order, tile by tile.
#include <QTest>
#include <algorithm>
#include <cmath>

#include "app/replay/ReplayLoop.h"
#include "core/base/Rng.h"
#include "core/servo/ServoState.h"
#include "core/session/SessionChannels.h"
#include "lessons/Assignment.h"
#include "lessons/LessonCatalog.h"
#include "tests/support/Rig.h"
#include "tests/support/SyntheticTooth.h"
#include "ui/tooth/PatchInbox.h"

using namespace core;
using namespace std::chrono_literals;
using app::ReplayLoop;
using app::ReplayTrack;
using recording::Player;
using recording::Recording;
using ui::replay::AttemptTimeline;
using ui::replay::Mark;

namespace {

constexpr std::uint64_t kGeneration = 7;

std::shared_ptr<const terrain::ToothAnatomy> block()
{
    support::Block made;
    made.side = 64;
    made.cellMm = 0.12;
    return support::makeBlock(made);
}

/// Records three strokes with two burs, an aid and a note. The second stroke is undone and redone; at the end all
/// strokes are undone.
Recording attempt()
{
    support::Rig rig;
    rig.open(block());
    rig.send(core::servo::SetDrill{true});
    const auto stroke = [&rig](double x, int ticks) {
        rig.lean(x, 0.0, 2.0, ticks);
        rig.lift();
        rig.run(40);
    };
    stroke(-1.2, 120);
    rig.send(session::SetAids{core::servo::kMirrorAid});
    stroke(0.0, 150);
    rig.send(session::Undo{});
    rig.run(60);
    rig.send(session::Redo{});
    rig.run(60);
    rig.send(session::AddNote{5});
    rig.send(session::AddNote{core::servo::kRestNote});
    rig.run(50);
    rig.send(session::AddNote{core::servo::kWorkNote});
    rig.send(core::servo::SetBur{3});
    rig.run(20);
    stroke(1.2, 130);
    rig.send(session::Reload{});
    rig.run(100);
    rig.settle();
    return rig.session->recordingSoFar().value();
}

/// Applies states and patches as the view does.
struct Viewer
{
    explicit Viewer(const std::shared_ptr<const terrain::ToothAnatomy>& anatomy) : tooth(anatomy)
    {
        inbox.setGeneration(kGeneration);
    }

    void look()
    {
        for (core::servo::TilePatch patch; links->patches.tryPop(patch);)
            inbox.take(patch);
        for (const core::servo::TilePatch& patch : inbox.complete())
            ui::tooth::write(patch, tooth);
        inbox.complete().clear();
    }
    [[nodiscard]] double shownS() const { return links->session.latest().recordedS; }

    std::unique_ptr<session::UiChannels> links = std::make_unique<session::UiChannels>();
    ui::tooth::PatchInbox inbox;
    terrain::Tooth tooth;
};

std::unique_ptr<ReplayTrack> trackOf(const Recording& recording, Viewer& viewer)
{
    return ReplayTrack::make(recording, *viewer.links, kGeneration).value();
}

std::unique_ptr<ReplayTrack> preparedTrackOf(const Recording& recording, Viewer& viewer)
{
    auto track = trackOf(recording, viewer);
    while (track->prepare(1000)) {
    }
    return track;
}

void prepareAll(ReplayLoop& replay)
{
    for (int n = 0; n < 100; ++n)
        replay.preparing().tick(5ms);
}

}  // namespace

class TestReplayTrack : public QObject
{
    Q_OBJECT
private slots:
    void everyMomentComesToTheViewAsItWas()
    {
        const Recording made = attempt();
        const auto truth = Player::make(made).value();
        while (truth->advance(1000)) {
        }
        Viewer viewer(made.anatomy());
        const auto track = preparedTrackOf(made, viewer);
        Rng rng(4);
        int rises = 0;
        double deepest = 0.0;
        for (int n = 0; n < 300; ++n) {
            const double seconds = rng.uniform(0.0, track->lengthS());
            const std::vector<float> before = viewer.tooth.top;
            track->show(seconds);
            viewer.look();
            QCOMPARE(viewer.tooth.top, truth->heightsAt(truth->tickAt(seconds)));
            QVERIFY(std::abs(viewer.shownS() - seconds) < 0.005);
            const core::servo::ServoState& state = viewer.links->servo.latest();
            QCOMPARE(state.toothGeneration, kGeneration);
            const core::servo::ServoState was = truth->stateAt(truth->tickAt(seconds));
            const core::servo::ServoState next = truth->stateAt(truth->tickAt(seconds) + Player::kTicksAPose);
            QCOMPARE(state.burIndex, was.burIndex);
            QVERIFY(state.anchorMm.z >= std::min(was.anchorMm.z, next.anchorMm.z) - 1.0e-9);
            QVERIFY(state.anchorMm.z <= std::max(was.anchorMm.z, next.anchorMm.z) + 1.0e-9);
            // The volumes shown next to the tooth are those of this time.
            const double removed = viewer.links->session.latest().removedMm3[1];
            const double still = terrain::volumes(viewer.tooth)[1];
            const double whole = terrain::volumes(terrain::Tooth(made.anatomy()))[1];
            QVERIFY(std::abs(removed - (whole - still)) < 1.0e-6);
            deepest = std::max(deepest, removed);
            for (std::size_t k = 0; k < before.size(); ++k)
                if (viewer.tooth.top[k] > before[k]) {
                    ++rises;
                    break;
                }
        }
        QVERIFY2(rises > 50, "going back puts material back");
        QVERIFY(deepest > 0.05);
        // The two ends of the recording.
        track->show(track->lengthS());
        viewer.look();
        QCOMPARE(viewer.tooth.top, made.anatomy()->top);
        QCOMPARE(viewer.shownS(), track->lengthS());
    }

    void showsLargeChangesToo()
    {
        // More tiles change at once than the queue to the view holds, and the view takes them late.
        support::Block block;
        block.side = 512;
        block.cellMm = 0.02;
        block.bottomMm = -0.01;  // so thin that the first touch of the bur bores through
        const auto anatomy = support::makeBlock(block);
        core::servo::ServoSettings settings;
        settings.hardness.material.fill({100.0, 0.0});
        Recording made(settings, anatomy);
        made.append({core::servo::ServoEvent::Kind::Drill, 0, {}, 1});
        made.append({core::servo::ServoEvent::Kind::Tick, 1000, {-4.5F, 4.5F, 1.0F}, 0});
        for (int n = 0; n < 4000; ++n)
            made.append({core::servo::ServoEvent::Kind::Tick,
                         1000,
                         {-4.5F + 0.6F * std::floor(static_cast<float>(n) / 250.0F),
                          4.5F - 0.036F * static_cast<float>(n % 250), -1.0F},
                         0});
        const auto outcome = recording::replay(made);
        Viewer viewer(anatomy);
        const auto track = preparedTrackOf(made, viewer);
        auto& links = *viewer.links;
        history::TiledHeights view(anatomy->grid, anatomy->top);
        int patches = 0;
        for (int n = 0; n < 20; ++n) {
            for (core::servo::TilePatch patch; links.patches.tryPop(patch); ++patches)
                view.setTile(patch.tileX, patch.tileY, patch.top);
            track->show(60.0);
        }
        for (core::servo::TilePatch patch; links.patches.tryPop(patch); ++patches)
            view.setTile(patch.tileX, patch.tileY, patch.top);
        QVERIFY2(patches > 512, qPrintable(QString::number(patches)));
        QCOMPARE(view.flat(), outcome->tooth.top);
        QVERIFY(links.session.latest().perforated);
    }

    void theCourseTellsStrokesAndMarks()
    {
        const Recording made = attempt();
        Viewer viewer(made.anatomy());
        const auto track = trackOf(made, viewer);
        QCOMPARE(track->course().lengthS, track->lengthS());
        QVERIFY(track->course().strokes.empty());
        while (track->prepare(1000)) {
        }
        const AttemptTimeline course = track->course();
        QCOMPARE(course.readyS, course.lengthS);
        QCOMPARE(course.strokes.size(), 3U);
        QCOMPARE(course.strokes[0].burIndex, course.strokes[1].burIndex);
        QCOMPARE(course.strokes[2].burIndex, std::uint8_t{3});
        QList<Mark::Kind> kinds;
        for (const Mark& mark : course.marks)
            kinds << mark.kind;
        QCOMPARE(kinds, (QList<Mark::Kind>{Mark::Kind::Aids, Mark::Kind::Undo, Mark::Kind::Redo, Mark::Kind::Note,
                                           Mark::Kind::Bur, Mark::Kind::StartAgain}));
        // A pause spent elsewhere is listed as a rest, and has no mark.
        QCOMPARE(course.rests.size(), 1U);
        const auto [restFromS, restToS] = course.rests.front();
        QVERIFY2(std::abs(restToS - restFromS - 0.05) < 0.02, qPrintable(QString::number(restToS - restFromS)));
        QVERIFY(restFromS > course.strokes[1].toS && restToS < course.strokes[2].fromS);
        // Stepping forward shows each state of the tooth once: whole, one stroke, two, undone, redone, ...
        std::vector<std::size_t> cut;
        for (double at = 0.0; at < course.lengthS; at = course.stepAfter(at)) {
            track->show(at);
            viewer.look();
            std::size_t columns = 0;
            for (std::size_t k = 0; k < viewer.tooth.top.size(); ++k)
                columns += viewer.tooth.top[k] < made.anatomy()->top[k] ? 1U : 0U;
            cut.push_back(columns);
        }
        QCOMPARE(cut.size(), 7U);
        QCOMPARE(cut[0], 0U);
        QVERIFY(cut[1] > 0 && cut[2] > cut[1]);
        QCOMPARE(cut[3], cut[1]);
        QCOMPARE(cut[4], cut[2]);
        QVERIFY(cut[5] > cut[4]);
        QCOMPARE(cut[6], 0U);
        // Steps back to the beginning.
        double at = course.lengthS;
        for (std::size_t n = cut.size(); n-- > 0;)
            at = course.stepBefore(at);
        QCOMPARE(at, 0.0);
    }

    void pointsAreTouchedInTheirTime()
    {
        const lessons::Lesson lesson = lessons::lessonNamed("orientation-1-touch").value();
        const auto assigned = lessons::assign(lesson).value();
        const auto& asked = std::get<grading::PointsToTouch>(*assigned.assignment.exercise);
        support::Rig rig;
        rig.open(assigned.assignment.anatomy, 1, lesson.json);
        rig.run(200);
        for (const std::size_t point : {2U, 0U}) {
            rig.lean(asked.pointsMm[point].x, asked.pointsMm[point].y, 0.5, 200);
            rig.lift();
        }
        rig.settle();
        Viewer viewer(assigned.assignment.anatomy);
        const auto track = trackOf(rig.session->recordingSoFar().value(), viewer);
        QCOMPARE(track->course().points.size(), asked.pointsMm.size());
        QVERIFY(!track->course().points[0].touchedAtS);
        while (track->prepare(100)) {
        }
        const AttemptTimeline course = track->course();
        QVERIFY(course.points[0].touchedAtS && course.points[2].touchedAtS && !course.points[1].touchedAtS);
        QVERIFY(*course.points[2].touchedAtS < *course.points[0].touchedAtS);
        QCOMPARE(course.points[0].placeMm, asked.pointsMm[0]);
        std::vector<std::uint64_t> order;
        for (const Mark& mark : course.marks)
            if (mark.kind == Mark::Kind::Touched)
                order.push_back(mark.value);
        QCOMPARE(order, (std::vector<std::uint64_t>{2, 0}));
        QCOMPARE(course.stepAfter(0.0), *course.points[2].touchedAtS);
    }

    void aLessonsInfractionsAreFound()
    {
        const lessons::Lesson lesson = lessons::lessonNamed("block-line").value();
        const auto assigned = lessons::assign(lesson).value();
        support::Rig rig;
        rig.open(assigned.assignment.anatomy, 1, lesson.json);
        rig.send(core::servo::SetBur{0});
        rig.send(core::servo::SetDrill{true});
        rig.run(30);
        // Drills far away from the line.
        rig.lean(3.5, 3.5, 4.0, 1500);
        rig.lift();
        rig.settle();
        const Recording made = rig.session->recordingSoFar().value();
        const auto known = lessons::markAgain(made).value().conduct.infractions;
        QVERIFY(!known.empty());
        Viewer viewer(made.anatomy());
        const auto track = trackOf(made, viewer);
        QVERIFY(track->ideal() != nullptr);
        while (track->prepare(300)) {
        }
        QVERIFY(track->course().infractions == known);
    }

    void playsAtAnySpeedAndStopsAtTheEnd()
    {
        const Recording made = attempt();
        Viewer viewer(made.anatomy());
        ReplayLoop replay(trackOf(made, viewer));
        prepareAll(replay);
        const double lengthS = replay.attempt().lengthS();
        QVERIFY(lengthS > 1.0);
        const auto beat = [&](int beats) {
            for (int n = 0; n < beats; ++n)
                replay.tick(10ms);
            viewer.look();
            return viewer.shownS();
        };
        const auto near = [](double a, double b) { return std::abs(a - b) < 0.005; };
        QVERIFY(near(beat(20), 0.2));
        replay.setSpeed(0.1);
        QVERIFY(near(beat(100), 0.3));
        replay.setPaused(true);
        QVERIFY(near(beat(100), 0.3));
        replay.seek(0.9);
        QVERIFY(near(beat(1), 0.9));
        QVERIFY(near(beat(50), 0.9));
        replay.seek(0.1);
        QVERIFY(near(beat(1), 0.1));
        replay.setSpeed(16.0);
        replay.setPaused(false);
        QVERIFY(near(beat(2), 0.42));
        QVERIFY(!replay.takeEnd());
        QCOMPARE(beat(100), lengthS);
        QVERIFY(replay.takeEnd());
        QVERIFY2(!replay.takeEnd(), "told once");
        QCOMPARE(viewer.tooth.top, made.anatomy()->top);  // all strokes were undone
        // While held at its end, the replay can be moved back. When released there, it starts again from the beginning.
        replay.setSpeed(1.0);
        replay.seek(0.5);
        QVERIFY(near(beat(5), 0.5));
        replay.seek(lengthS);
        beat(1);
        QVERIFY2(!replay.takeEnd(), "who looks at the end has not played to it");
        replay.setPaused(false);
        QVERIFY(near(beat(10), 0.09));
    }

    void showsWhatIsReadyUntilTheRestIs()
    {
        const Recording made = attempt();
        Viewer viewer(made.anatomy());
        ReplayLoop replay(trackOf(made, viewer));
        replay.setPaused(true);
        replay.seek(replay.attempt().lengthS() - 0.05);
        replay.tick(10ms);
        viewer.look();
        QVERIFY(viewer.shownS() < 0.01);
        replay.preparing().tick(5ms);  // prepares a thousand ticks
        replay.tick(10ms);
        const double soFar = viewer.shownS();
        QVERIFY(soFar > 0.9 && soFar <= replay.attempt().readyS() && soFar < replay.attempt().lengthS());
        prepareAll(replay);
        replay.tick(10ms);
        QVERIFY(std::abs(viewer.shownS() - replay.attempt().lengthS() + 0.05) < 0.005);
    }

    void anotherBesideIsAtTheSameShareOfItsTime()
    {
        const Recording made = attempt();
        support::Rig rig;
        rig.open(block());
        rig.send(core::servo::SetDrill{true});
        rig.lean(0.0, 0.0, 2.0, 300);
        rig.lift();
        rig.settle();
        const Recording shorter = rig.session->recordingSoFar().value();
        Viewer viewer(made.anatomy());
        Viewer besideViewer(shorter.anatomy());
        ReplayLoop replay(trackOf(made, viewer));
        replay.putBeside(trackOf(shorter, besideViewer));
        prepareAll(replay);
        replay.setPaused(true);
        for (const double share : {0.25, 0.8, 0.5, 1.0}) {
            replay.seek(share * replay.attempt().lengthS());
            replay.tick(10ms);
            QVERIFY(std::abs(viewer.shownS() - share * replay.attempt().lengthS()) < 0.005);
            QVERIFY(std::abs(besideViewer.shownS() - share * replay.beside()->lengthS()) < 0.005);
        }
        besideViewer.look();
        QCOMPARE(besideViewer.tooth.top, rig.session->toothSoFar()->top);
    }
};

QTEST_APPLESS_MAIN(TestReplayTrack)
#include "tst_replay_track.moc"
