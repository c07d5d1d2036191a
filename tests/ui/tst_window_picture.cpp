// SPDX-License-Identifier: GPL-3.0-or-later
// What the main window shows of the tooth, drawn with OpenGL.
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>

#include "core/servo/ServoState.h"
#include "core/session/SessionChannels.h"
#include "core/teeth/Block.h"
#include "tests/support/OpenGlMain.h"
#include "tests/ui/WindowTest.h"
#include "ui/catalog/LessonsPage.h"
#include "ui/inside/SectionView.h"
#include "ui/practice/InfractionCard.h"
#include "ui/practice/StereoCard.h"
#include "ui/replay/TimeLine.h"
#include "ui/toothchooser/ArchView.h"
#include "ui/toothchooser/Mouth.h"

using namespace core::session;
using namespace core::servo;
using namespace ui::kit;
using namespace ui::practice;
using namespace ui::toothchooser;
using namespace ui::window;
using core::terrain::Material;

class TestWindowPicture : public support::WindowTest
{
    Q_OBJECT
private slots:
    void initTestCase() { prepare(); }
    void init() { begin(); }
    void cleanup() { end(); }

    void theStereoPageHasAWayBack()
    {
        using ui::render::Stereo;
        auto* card = child<StereoCard>();
        auto* mode = card->findChild<QComboBox*>();
        const auto shown = [this] { return m_window->view().settings().presentation; };
        const auto before = shown();
        QCOMPARE(before.stereo, Stereo::Off);
        press(Qt::Key_S, Qt::ShiftModifier);
        QVERIFY(card->isVisible());
        QCOMPARE(shown().stereo, Stereo::RedCyan);
        mode->setCurrentIndex(2);
        QCOMPARE(shown().stereo, Stereo::SideBySide);
        for (QSlider* slider : card->findChildren<QSlider*>())
            slider->setValue(slider->maximum());
        QVERIFY(shown().apart > before.apart);
        // Asked for twice, it does not take its own doing for what was there before.
        actions().stereoPage->trigger();
        press(Qt::Key_Escape);
        QVERIFY(!card->isVisible() && !actions().stereo->isChecked());
        QVERIFY(shown() == before);
        press(Qt::Key_S, Qt::ShiftModifier);
        mode->setCurrentIndex(2);
        click("keepStereo");
        QVERIFY(!card->isVisible());
        QCOMPARE(shown().stereo, Stereo::SideBySide);
        spoil();
    }

    void thePressedToothKeepsItsPlace()
    {
        spoil();
        beginLesson(support::assigned(support::shippedWhere([](const lessons::Lesson& lesson) {
                                          return lesson.steps.size() > 1 &&
                                                 lesson.steps[0].doneWhen == lessons::Reached::DecayFound;
                                      }).lesson->id));
        QCoreApplication::processEvents();
        auto& view = m_window->view();
        const QRect before = view.geometry();
        const auto* section = child<ui::inside::SectionView>();
        const auto* step = child<QLabel>("lessonStep");
        const QString firstStep = step->text();
        QTest::mousePress(&view, Qt::LeftButton);
        QVERIFY(view.isPressed());
        core::grading::Infraction breach;
        breach.breach = core::grading::RuleViolation::RidgeCut;
        m_window->infractionView().show(breach, true);
        SessionState session;
        session.toothGeneration = m_generation;
        session.removedMm3[static_cast<std::size_t>(Material::Caries)] = 1.0;
        take({}, session);
        QTRY_VERIFY(step->text() != firstStep);
        frame();
        QCOMPARE(view.geometry(), before);
        QVERIFY(view.isPressed() && !section->isVisible());
        QTest::mouseRelease(&view, Qt::LeftButton);
        QVERIFY(!view.isPressed() && section->isVisible() && child<ui::practice::InfractionCard>()->isVisible());
        QTRY_VERIFY(view.geometry().left() > before.left());
        QCOMPARE(view.geometry().top(), before.top());
    }

    void whatLiesOverTheToothKeepsOffTheBur()
    {
        spoil();
        auto& view = m_window->view();
        const auto* notice = child<QLabel>("notice")->parentWidget();
        const auto* card = child<ui::practice::InfractionCard>();
        SessionState session;
        session.toothGeneration = m_generation;
        const auto openPulp = [&](const core::servo::ServoState& servo) {
            session.pulpExposedMm2 = 0.0;
            take(servo, session);
            session.pulpExposedMm2 = 0.01;
            take(servo, session);
        };
        const auto burUnder = [&](const QWidget& overlay) {
            const QPoint at = overlay.geometry().center() - view.pos();
            const ui::render::Ray ray = view.camera().rayThrough({at.x(), at.y()});
            core::servo::ServoState servo;
            servo.tick = 1;
            servo.anchorMm = ray.originMm + ray.direction * view.camera().distanceMm();
            return servo;
        };
        const auto isOff = [&](const QWidget& overlay) {
            const auto bur = view.burAt();
            return bur && !overlay.geometry().contains(view.pos() + bur->toPoint());
        };
        QTest::mousePress(&view, Qt::LeftButton);
        openPulp({});
        QVERIFY(notice->isVisible());
        take(burUnder(*notice), session);
        QTRY_VERIFY(isOff(*notice));
        openPulp(burUnder(*notice));
        QVERIFY(notice->isVisible());
        QTRY_VERIFY(isOff(*notice));
        m_window->infractionView().show({}, true);
        take(burUnder(*card), session);
        QTRY_VERIFY(isOff(*card));
        QTest::mouseRelease(&view, Qt::LeftButton);
        frame();
        frame();  // the section has opened
        // The pointer goes to the card's button, and the bur follows it: the card stays.
        const QRect before = card->geometry();
        take(burUnder(*card), session);
        frame();
        QCOMPARE(card->geometry(), before);
    }

    void aLessonBeginsWithTheOutlineOfItsIdeal()
    {
        const auto isSeen = [this] { return m_window->view().settings().look.idealOutline; };
        std::uint8_t told = 0;
        const auto isTold = [&] {
            frame();
            for (const SessionCommand& command : allSent())
                if (const auto* aids = std::get_if<SetAids>(&command))
                    told = aids->aids;
            return (told & kIdealAid) != 0;
        };
        beginLesson(support::assigned("class1-36"));
        QVERIFY(actions().outline->isEnabled() && actions().outline->isChecked() && isSeen());
        QVERIFY(isTold());
        // What is chosen holds while the lesson is repeated.
        press(Qt::Key_O);
        QVERIFY(!isSeen() && !isTold());
        beginLesson(support::assigned("class1-36"));
        QVERIFY(!isSeen());
        beginLesson(support::assigned("class1-37"));
        QVERIFY(isSeen());
        for (const lessons::Assignment& locked : {support::exam(), support::assigned(lessons::Task::TouchPoints)}) {
            beginLesson(locked);
            const QString tip = actions().outline->toolTip();
            QVERIFY(!actions().outline->isEnabled() && !actions().outline->isChecked());
            press(Qt::Key_O);
            QVERIFY(!isSeen());
            beginLesson(support::assigned("class1-36"));
            QVERIFY(isSeen() && actions().outline->toolTip() != tip);
        }
        spoil();
    }

    void oneOfTheDepthColoursIsShown()
    {
        using ui::render::DepthColours;
        const auto shown = [this] { return m_window->view().settings().look.depthColours; };
        QCOMPARE(shown(), DepthColours::Off);
        press(Qt::Key_K);
        QCOMPARE(shown(), DepthColours::BelowOriginal);
        press(Qt::Key_K, Qt::ShiftModifier);
        QCOMPARE(shown(), DepthColours::AgainstIdeal);
        QVERIFY(!actions().depthColours->isChecked());
        forbid(&lessons::Aids::ideal);
        QCOMPARE(shown(), DepthColours::Off);
        QVERIFY(!actions().idealColours->isEnabled());
        m_window->lessonController().setAids({});
        QCOMPARE(shown(), DepthColours::AgainstIdeal);
        // A tooth without decay has no ideal.
        auto sound = std::make_shared<core::terrain::ToothAnatomy>(*support::syntheticMolar(64));
        for (core::terrain::ColumnLayers& column : sound->layers)
            column.cariesFloor = column.cariesRoof;
        show(sound);
        QVERIFY(!actions().idealColours->isEnabled());
        press(Qt::Key_K, Qt::ShiftModifier);
        QCOMPARE(shown(), DepthColours::Off);
    }

    void theBurTellsHowNearItIs()
    {
        ServoState servo;
        servo.tick = 1;
        servo.toothGeneration = m_generation;
        // Deep in what is to be kept beside the decay.
        servo.anchorMm = {support::kLesionX + 3.0, support::kLesionY, -3.0};
        const auto isShown = [this] {
            return child<TabularDigitsLabel>("marginFigure")->isVisible() &&
                   figure("marginFigure").startsWith(QChar(0x2212));
        };
        take(servo, {});
        QVERIFY(!isShown());
        press(Qt::Key_A);
        QTRY_VERIFY(isShown());
        const auto noted = allSent();
        QVERIFY(std::any_of(noted.begin(), noted.end(), [](const SessionCommand& c) {
            return std::holds_alternative<SetAids>(c) && (std::get<SetAids>(c).aids & kBurColourAid) != 0;
        }));
        forbid(&lessons::Aids::burColour);
        QTRY_VERIFY(!isShown());
        QVERIFY(!actions().burColour->isEnabled());
        m_window->lessonController().setAids({});
        press(Qt::Key_A);
        QTRY_VERIFY(!isShown());
    }

    void aHandIsHeldOnRequest()
    {
        QSignalSpy wanted(actions().fixture, &QAction::triggered);
        press(Qt::Key_Q);
        press(Qt::Key_Q);
        QCOMPARE(wanted.count(), 2);
        QVERIFY(wanted.front().front().toBool() && !wanted.back().front().toBool());
        forbid(&lessons::Aids::fixture);
        press(Qt::Key_Q);
        QCOMPARE(wanted.count(), 2);
    }

    void theHintGoesWithTheFirstCut()
    {
        spoil();
        auto* hint = child<QLabel>("hint");
        QVERIFY(hint->isVisible());
        m_window->setReplaying(true);
        QVERIFY2(!hint->isVisible(), "there is nothing to begin with");
        m_window->setReplaying(false);
        QVERIFY(hint->isVisible());
        ServoState servo;
        servo.tick = 1;
        servo.cutting = true;
        take(servo, {});
        QVERIFY(!hint->isVisible());
    }

    /// Two blocks whose pads are of other tissues look the same, cut or whole, until the answers have been graded.
    void whatIsToBeFeltIsNotShown()
    {
        spoil();
        lessons::Lesson lesson = *support::shippedWhere([](const lessons::Lesson& one) {
                                      return one.task == lessons::Task::TellLayers;
                                  }).lesson;
        const auto assignedWith = [&](std::uint64_t seed) {
            std::get<lessons::Block>(lesson.tooth).seed = seed;
            return lessons::assign(lesson).value().assignment;
        };
        const auto shown = [&](const lessons::Assignment& assignment, float depthMm) {
            beginLesson(assignment);
            ServoState servo;
            servo.tick = 1;
            servo.anchorMm = {core::teeth::kPadX[0], 0.0, 0.0};
            servo.touching = servo.drillOn = true;
            servo.materialUnderBur = std::get<core::grading::PadsToName>(*assignment.exercise).madeOf[0];
            std::vector<float> top = assignment.anatomy->top;
            for (std::size_t k = 0; k < top.size() / 2; ++k)
                if (top[k] > -1.0F)
                    top[k] -= depthMm;
            m_window->view().setHeights(top);
            take(servo, {});
            return m_window->grab().toImage();
        };
        const lessons::Assignment first = assignedWith(1);
        lessons::Assignment other = assignedWith(2);
        for (std::uint64_t seed = 3; *other.exercise == *first.exercise; ++seed)
            other = assignedWith(seed);
        static_cast<void>(shown(other, 0.0F));  // where everything finds its place
        QImage one;
        // The window is laid out, and the bur stands still, when two pictures are the same.
        QTRY_VERIFY(std::exchange(one, shown(first, 0.0F)) == one);
        QTRY_VERIFY(shown(other, 0.0F) == one);
        QTRY_VERIFY(shown(first, 0.7F) == one);
        for (const char* name : {"materialFigure", "depthFigure", "pulpFigure", "decayFigure", "enamelRemoved"})
            QVERIFY2(!child<TabularDigitsLabel>(name)->isVisible(), name);
        for (QAction* aid :
             {actions().section, actions().radiograph, actions().depthColours, actions().mirror, actions().history})
            QVERIFY2(!aid->isEnabled(), qPrintable(aid->text()));
        // A recording of such a block, one's own for one, tells no more.
        const std::uint64_t own = m_generation;
        m_window->setReplaying(true, 10.0);
        const auto replayed = std::make_shared<core::terrain::ToothAnatomy>(*first.anatomy);
        show(replayed);
        QImage played;
        QTRY_VERIFY(std::exchange(played, m_window->view().picture()) == played);
        m_window->view().setHeights(std::vector<float>(replayed->top.size(), -1.5F));
        QVERIFY(m_window->view().picture() == played);
        QVERIFY(!child<TabularDigitsLabel>("materialFigure")->isVisible());
        m_window->setReplaying(false);
        m_window->showTooth(first.anatomy, own, {});
        // By keys: Tab leads to the choices, the space bar takes one, and the last answer is the one that is sent.
        static_cast<void>(sent());
        auto* enamel = child<QPushButton>("pad01");
        auto* dentin = child<QPushButton>("pad02");
        enamel->setFocus();
        QTest::keyClick(enamel, Qt::Key_Space);
        QTest::mouseClick(dentin, Qt::LeftButton);
        const std::vector<SessionCommand> answers = sent();
        QCOMPARE(answers.size(), std::size_t{2});
        QCOMPARE(std::get<AddNote>(answers[0]).code, core::grading::answerNote(0, Material::Enamel));
        QCOMPARE(std::get<AddNote>(answers[1]).code, core::grading::answerNote(0, Material::Dentin));
        QVERIFY(dentin->isChecked() && !enamel->isChecked());
        QVERIFY(!child<QPushButton>("exerciseGrade")->isVisible());
        click("pad11");
        click("pad20");
        QVERIFY(child<QPushButton>("exerciseGrade")->isVisible());
        m_window->showScore(support::sheet(3.2, 40, 0.5), {});
        actions().back->trigger();
        QVERIFY(child<TabularDigitsLabel>("materialFigure")->isVisible());
        QVERIFY(!dentin->isEnabled() && child<QLabel>("padTruth0")->isVisible());
        QVERIFY(m_window->grab().toImage() != one);
    }

    void pointsAndRemarksAreMarkedInAReplay()
    {
        spoil();
        m_window->setReplaying(true, 60.0);
        show();
        const auto pictureAt = [&](double seconds) {
            SessionState session;
            session.toothGeneration = m_generation;
            session.recordedS = seconds;
            take({}, session);
            return m_window->view().picture();
        };
        ui::replay::AttemptTimeline course;
        course.lengthS = course.readyS = 60.0;
        m_window->replayView().setCourse(course);
        const QImage bare = pictureAt(10.0);
        course.points = {{{-1.0, 0.0}, 0.6, 20.0}, {{1.5, 1.0}, 0.6, std::nullopt}};
        course.marks = {{ui::replay::Mark::Kind::Touched, 20.0, 0}};
        m_window->replayView().setCourse(course);
        const QImage ringed = pictureAt(10.0);
        QVERIFY(ringed != bare);
        const QImage touched = pictureAt(21.0);
        QVERIFY(touched != ringed);
        QCOMPARE(pictureAt(40.0), touched);
        QCOMPARE(pictureAt(11.0), ringed);
        // Remarks are read where they were meant.
        const auto* remark = child<QLabel>("remark");
        m_window->replayView().setRemarks(
            {{20.0, glm::dvec3(1.0, 0.5, -0.5), "Ada Teach", "The wall <b>leans</b> in."}});
        QVERIFY(pictureAt(20.0) != touched);
        QVERIFY(remark->isVisible());
        QCOMPARE(remark->text(), QString("Ada Teach: The wall <b>leans</b> in."));
        QCOMPARE(remark->textFormat(), Qt::PlainText);
        // More of the recording becomes known: what was said of it stays.
        m_window->replayView().setCourse(course);
        auto* line = child<ui::replay::TimeLine>("timeLine");
        QTRY_VERIFY(line->saidAt(QPoint(qRound(line->xOf(20.0)), 12)).join(' ').contains("leans"));
        QCOMPARE(pictureAt(40.0), touched);
        QVERIFY(!remark->isVisible());
    }

    void theWholeMouthIsReachedWithM()
    {
        press(Qt::Key_M);
        auto* mouth = child<Mouth>();
        QVERIFY(mouth != nullptr && mouth->isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(mouth->isReady(), 30'000);
        QTRY_VERIFY(mouth->hasFocus());
        QSignalSpy chosen(m_window.get(), &MainWindow::toothChosen);
        mouth->setSelected(35);
        press(Qt::Key_Right);
        QCOMPARE(child<ArchView>()->selected(), 36);
        // The flat arches know what was chosen, and back again.
        press(Qt::Key_M);
        QVERIFY(child<ArchView>()->isVisible() && !mouth->isVisible());
        press(Qt::Key_M);
        QVERIFY(mouth->isVisible());
        press(Qt::Key_Left);
        press(Qt::Key_Return);
        QCOMPARE(chosen.count(), 1);
        QCOMPARE(chosen.front().front().toInt(), 35);
        spoil();
    }

    /// An open list has the keys to itself only on a real display.
    void aToothOfTheArchIsSearchedFor()
    {
        m_window->lessonsPage().setLessons(support::catalog(), {});
        auto* page = child<ui::catalog::LessonsPage>();
        const auto* search = page->findChild<QLineEdit*>();
        actions().lessons->trigger();
        const auto choose = [&](const QList<Qt::Key>& keys) {
            QTest::mouseClick(child<QPushButton>("pickTooth"), Qt::LeftButton);
            QVERIFY(page->findChild<QFrame*>("archPopup") != nullptr);
            for (const Qt::Key key : keys)
                QTest::keyClick(QApplication::focusWidget(), key);
            QTRY_VERIFY(page->findChild<QFrame*>("archPopup") == nullptr);
        };
        choose({Qt::Key_Down, Qt::Key_Right, Qt::Key_Return});
        QCOMPARE(search->text(), QString("32"));
        QVERIFY(child<QLabel>("lessonTitle")->text().contains("32"));
        choose({Qt::Key_Right, Qt::Key_Escape});
        QCOMPARE(search->text(), QString("32"));
    }
};

int main(int argc, char** argv)
{
    return support::openGlMain<TestWindowPicture>(argc, argv);
}

#include "tst_window_picture.moc"
