// SPDX-License-Identifier: GPL-3.0-or-later
// The whole program operated with a mouse, a pen, a keyboard or a gamepad alone: one lesson of each kind, from the list
// of lessons to the score and back.
#include <array>
#include <memory>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include <QAbstractButton>
#include <QApplication>
#include <QButtonGroup>
#include <QListView>
#include <QPointingDevice>
#include <QSlider>
#include <QTabletEvent>
#include <QWindow>

#include "core/grading/Exercise.h"
#include "lessons/LessonCatalog.h"
#include "tests/app/SchoolWindow.h"
#include "tests/support/OpenGlMain.h"
#include "tests/support/Trials.h"
#include "tests/support/VirtualController.h"
#include "ui/catalog/LessonsPage.h"
#include "ui/devices/DevicesPage.h"
#include "ui/devices/PedalCard.h"
#include "ui/kit/AppSettings.h"
#include "ui/practice/ExerciseCard.h"
#include "ui/scoring/ScorePage.h"
#include "ui/scoring/ScorePredictionPage.h"
#include "ui/text/LessonTexts.h"

#include "ui/tooth/ToothView.h"

using support::VirtualController;

namespace {

/// One shipped lesson of each task; one of them is an exam.
constexpr std::array kKinds{"orientation-3-layers", "orientation-1-touch", "orientation-2-hold",
                            "block-line",           "class1-36",           "exam-36-decay"};

constexpr std::array kDevices{"mouse", "pen", "keyboard", "gamepad"};

/// ms after which a bur that has not reached the tooth is lifted and pushed again.
constexpr int kSecondPushMs = 5000;

QModelIndex indexOf(const QListView& list, const QString& lesson)
{
    for (int row = 0; row < list.model()->rowCount(); ++row)
        if (list.model()->index(row, 0).data().toString() == lesson)
            return list.model()->index(row, 0);
    return {};
}

/// A user who has only one input device.
class Hand
{
public:
    explicit Hand(QWidget& window) : m_window(window) {}
    virtual ~Hand() = default;
    Hand(const Hand&) = delete;
    Hand& operator=(const Hand&) = delete;

    virtual void press(QWidget& button) = 0;
    /// Presses the button that opens the lessons from the practice room.
    virtual void openLessons(QWidget& button) { press(button); }
    /// Selects the lesson with this title in the list and starts it.
    virtual void start(QListView& list, const QString& lesson, QWidget& button) = 0;
    virtual void raiseSlider(QSlider& slider) = 0;
    /// Raises the force from the default of 0.6 N to 1.1 N.
    virtual void raiseForce(QSlider& slider) = 0;
    virtual void grade(QWidget& button) { press(button); }
    virtual void goBack(QWidget& button) { press(button); }
    /// Pushes the bur down; lift() raises it again.
    virtual void push(ui::tooth::ToothView& view, glm::dvec3 placeMm) = 0;
    virtual void lift(ui::tooth::ToothView& view) = 0;

protected:
    QWidget& m_window;
};

/// An input device that points at a position on the screen: mouse or pen.
class PointingHand : public Hand
{
public:
    using Hand::Hand;
    void press(QWidget& button) override { tap(button, button.rect().center()); }
    void start(QListView& list, const QString& lesson, QWidget& button) override
    {
        // The list is filled again when the database has answered.
        const auto isChosen = [&] { return list.currentIndex().data().toString() == lesson; };
        const auto choose = [&] {
            const QModelIndex index = indexOf(list, lesson);
            list.scrollTo(index);
            tap(*list.viewport(), list.visualRect(index).center());
        };
        QVERIFY(support::pressUntil(isChosen, choose));
        press(button);
    }
    void raiseSlider(QSlider& slider) override { tap(slider, {slider.width() * 3 / 4, slider.height() / 2}); }
    void raiseForce(QSlider& slider) override { raiseSlider(slider); }
    void push(ui::tooth::ToothView& view, glm::dvec3 placeMm) override
    {
        const glm::dvec2 pixel = view.camera().pixelOf(placeMm);
        m_at = view.mapTo(&m_window, QPoint(qRound(pixel.x), qRound(pixel.y)));
        hover(m_at);
        down(m_at);
    }
    void lift(ui::tooth::ToothView&) override { up(m_at); }
    void tap(QWidget& widget, QPoint place)
    {
        const QPoint at = widget.mapTo(&m_window, place);
        hover(at);
        down(at);
        up(at);
    }

protected:
    virtual void hover(QPoint at) = 0;
    virtual void down(QPoint at) = 0;
    virtual void up(QPoint at) = 0;

private:
    QPoint m_at;
};

class MouseHand final : public PointingHand
{
public:
    using PointingHand::PointingHand;

protected:
    void hover(QPoint at) override { QTest::mouseMove(m_window.windowHandle(), at); }
    void down(QPoint at) override { QTest::mousePress(m_window.windowHandle(), Qt::LeftButton, {}, at); }
    void up(QPoint at) override { QTest::mouseRelease(m_window.windowHandle(), Qt::LeftButton, {}, at); }
};

/// A pen. An event that the window does not accept from the pen is sent again as a mouse event, as Qt does.
class PenHand final : public PointingHand
{
public:
    using PointingHand::PointingHand;

protected:
    void hover(QPoint at) override
    {
        if (!send(QEvent::TabletMove, at, 0.0, Qt::NoButton, Qt::NoButton))
            QTest::mouseMove(m_window.windowHandle(), at);
    }
    void down(QPoint at) override
    {
        if (!send(QEvent::TabletPress, at, 0.8, Qt::LeftButton, Qt::LeftButton))
            QTest::mousePress(m_window.windowHandle(), Qt::LeftButton, {}, at);
    }
    void up(QPoint at) override
    {
        if (!send(QEvent::TabletRelease, at, 0.0, Qt::LeftButton, Qt::NoButton))
            QTest::mouseRelease(m_window.windowHandle(), Qt::LeftButton, {}, at);
    }

private:
    bool send(QEvent::Type type, QPoint at, double pressure, Qt::MouseButton button, Qt::MouseButtons buttons)
    {
        QTabletEvent event(type, &m_pen, at, m_window.mapToGlobal(at), pressure, 0.0F, 0.0F, 0.0F, 0.0, 0.0F,
                           Qt::NoModifier, button, buttons);
        event.ignore();
        QCoreApplication::sendEvent(m_window.windowHandle(), &event);
        return event.isAccepted();
    }
    QPointingDevice m_pen{QStringLiteral("pen"),
                          1,
                          QInputDevice::DeviceType::Stylus,
                          QPointingDevice::PointerType::Pen,
                          QInputDevice::Capability::Pressure,
                          1,
                          1};
};

/// An input device that moves the focus from control to control: keyboard or gamepad.
class SteppingHand : public Hand
{
public:
    static constexpr int kForceSteps = 5;
    using Hand::Hand;
    void press(QWidget& button) override
    {
        goTo(button);
        choose();
    }
    void start(QListView& list, const QString& lesson, QWidget& /*button*/) override
    {
        goTo(list);
        constexpr int kMostSteps = 400;
        for (int k = 0; k < kMostSteps && list.currentIndex().row() != indexOf(list, lesson).row(); ++k) {
            stepInList(list, list.currentIndex().row() < indexOf(list, lesson).row());
            if (QTest::currentTestFailed())
                return;
        }
        QCOMPARE(list.currentIndex().data().toString(), lesson);
        choose();
    }
    void raiseSlider(QSlider& slider) override
    {
        goTo(slider);
        right();
    }
    void raiseForce(QSlider& slider) override
    {
        for (int k = 0; k < kForceSteps; ++k)
            raiseSlider(slider);
    }

protected:
    virtual void next() = 0;
    virtual void right() = 0;
    virtual void stepInList(QListView& list, bool isOn) = 0;
    virtual void choose() = 0;
    void goTo(const QWidget& widget)
    {
        constexpr int kMostControls = 120;
        for (int k = 0; k < kMostControls && !widget.hasFocus(); ++k)
            step(widget);
        QVERIFY2(widget.hasFocus(), qPrintable(QStringLiteral("the focus does not come to %1 %2")
                                                   .arg(widget.metaObject()->className(), widget.accessibleName())));
    }
    /// Returns whether the focus is on another button of the same button group.
    static bool isBeside(const QWidget& wanted)
    {
        const auto* now = qobject_cast<QAbstractButton*>(QApplication::focusWidget());
        const auto* button = qobject_cast<const QAbstractButton*>(&wanted);
        return now != nullptr && button != nullptr && now->group() != nullptr && now->group() == button->group();
    }
    /// Takes the next step towards a control: moves the focus to the next control, or to the next button of the group.
    virtual void step(const QWidget& /*wanted*/) { next(); }
};

class KeyHand final : public SteppingHand
{
public:
    using SteppingHand::SteppingHand;
    void openLessons(QWidget&) override { key(Qt::Key_F2); }
    void grade(QWidget&) override { key(Qt::Key_G); }
    void goBack(QWidget&) override { key(Qt::Key_Escape); }
    void raiseForce(QSlider&) override
    {
        for (int k = 0; k < kForceSteps; ++k)
            key(Qt::Key_Period);
    }
    void push(ui::tooth::ToothView& view, glm::dvec3) override
    {
        QTRY_VERIFY_WITH_TIMEOUT(view.hasFocus(), support::kPatienceMs);
        QTest::keyPress(m_window.windowHandle(), Qt::Key_PageDown);
    }
    void lift(ui::tooth::ToothView&) override { QTest::keyRelease(m_window.windowHandle(), Qt::Key_PageDown); }

protected:
    void next() override { key(Qt::Key_Tab); }
    void right() override { key(Qt::Key_Right); }
    void stepInList(QListView& list, bool isOn) override
    {
        const int before = list.currentIndex().row();
        key(isOn ? Qt::Key_Right : Qt::Key_Left);
        if (list.currentIndex().row() == before)
            key(isOn ? Qt::Key_PageDown : Qt::Key_PageUp);
    }
    void choose() override
    {
        key(qobject_cast<QAbstractButton*>(QApplication::focusWidget()) != nullptr ? Qt::Key_Space : Qt::Key_Return);
    }
    void step(const QWidget& wanted) override { key(isBeside(wanted) ? Qt::Key_Right : Qt::Key_Tab); }

private:
    void key(Qt::Key key) { QTest::keyClick(m_window.windowHandle(), key); }
};

class PadHand final : public SteppingHand
{
public:
    PadHand(QWidget& window, const ui::devices::PedalCard& card) : SteppingHand(window), m_card(card)
    {
        m_pad.setAxis(SDL_CONTROLLER_AXIS_TRIGGERLEFT, -1.0);
        m_pad.setAxis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, -1.0);
        QTRY_VERIFY_WITH_TIMEOUT(m_card.shown() != nullptr, support::kPatienceMs);
    }
    void grade(QWidget&) override { tap(SDL_CONTROLLER_BUTTON_START); }
    void goBack(QWidget&) override { tap(SDL_CONTROLLER_BUTTON_BACK); }
    void push(ui::tooth::ToothView&, glm::dvec3) override { m_pad.setAxis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, 0.9); }
    void lift(ui::tooth::ToothView&) override { m_pad.setAxis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, -1.0); }

protected:
    void next() override { tap(SDL_CONTROLLER_BUTTON_DPAD_DOWN); }
    void right() override { tap(SDL_CONTROLLER_BUTTON_DPAD_RIGHT); }
    void stepInList(QListView& list, bool isOn) override
    {
        tap(isOn ? SDL_CONTROLLER_BUTTON_DPAD_RIGHT : SDL_CONTROLLER_BUTTON_DPAD_LEFT);
        QVERIFY(list.hasFocus());
    }
    void choose() override { tap(SDL_CONTROLLER_BUTTON_A); }
    void step(const QWidget& wanted) override
    {
        if (isBeside(wanted))
            right();
        else
            next();
    }

private:
    /// Holds a gamepad button until the program has seen it, and releases it.
    void tap(int button)
    {
        const auto isHeld = [&] {
            return m_card.shown() != nullptr && m_card.shown()->isHeld(static_cast<std::size_t>(button));
        };
        m_pad.setButton(button, true);
        QTRY_VERIFY_WITH_TIMEOUT(isHeld(), support::kPatienceMs);
        m_pad.setButton(button, false);
        QTRY_VERIFY_WITH_TIMEOUT(!isHeld(), support::kPatienceMs);
        QCoreApplication::processEvents();
    }
    const ui::devices::PedalCard& m_card;
    VirtualController m_pad{"A pad", SDL_JOYSTICK_TYPE_GAMECONTROLLER, 6, 15};
};

void addHands()
{
    QTest::addColumn<QString>("device");
    for (const char* device : kDevices)
        QTest::newRow(device) << QString::fromLatin1(device);
}

}  // namespace

class TestOneInput : public support::SchoolWindow
{
    Q_OBJECT
private slots:
    void initTestCase()
    {
        QCOMPARE(SDL_InitSubSystem(SDL_INIT_JOYSTICK | SDL_INIT_GAMECONTROLLER), 0);
        makeSchool();
    }
    void cleanupTestCase() { SDL_QuitSubSystem(SDL_INIT_JOYSTICK | SDL_INIT_GAMECONTROLLER); }
    void init()
    {
        QLocale::setDefault(QLocale("en_GB"));
        ui::kit::memory().clear();
        takeCopyOfSchool();
    }
    void cleanup()
    {
        m_hand.reset();
        m_application.reset();
    }

    void aGuestComesToALesson_data() { addHands(); }
    void aGuestComesToALesson()
    {
        start();
        takeHand();
        WAIT_FOR(child<QPushButton>("practiseAsGuest")->isVisible());
        m_hand->press(*child<QPushButton>("practiseAsGuest"));
        WAIT_FOR(!isAtDoor());
        waitForTooth();
        doLesson("block-line");
    }

    void aLessonOfEachKindIsFinished_data() { addHands(); }
    void aLessonOfEachKindIsFinished()
    {
        QFETCH(const QString, device);
        doLessons({kKinds.begin(), kKinds.end()}, device);
    }

    /// Does every lesson with one of the input devices in turn. Runs at night only.
    void everyLessonIsFinished_data() { addHands(); }
    void everyLessonIsFinished()
    {
        QFETCH(const QString, device);
        if (!support::isNightly())
            QSKIP("at night only");
        std::vector<std::string> some;
        std::size_t turn = 0;
        for (const lessons::CatalogEntry& entry : lessons::readCatalog(lessons::teachersFolder()))
            if (entry.read.lesson && device == QLatin1String(kDevices.at(turn++ % kDevices.size())))
                some.push_back(entry.read.lesson->id);
        QVERIFY(some.size() > 10);
        doLessons(some, device);
    }

    /// A user whose pen has no buttons turns the view by the letters in its corner.
    void aPenChoosesASide()
    {
        start();
        beGuest();
        goToTooth();
        PenHand pen(window());
        ui::tooth::ToothView& view = window().view();
        const double elevationDeg = view.camera().elevationDeg();
        const double azimuthDeg = view.camera().azimuthDeg();
        const auto hasTurned = [&] {
            return view.camera().elevationDeg() != elevationDeg || view.camera().azimuthDeg() != azimuthDeg;
        };
        constexpr int kCornerPx = 104;  // px of the view, in which the letters are
        constexpr int kStepPx = 4;
        // The letters appear when the view has been drawn.
        const auto tapAll = [&] {
            for (int x = 0; x < kCornerPx && !hasTurned(); x += kStepPx)
                for (int y = 0; y < kCornerPx && !hasTurned(); y += kStepPx)
                    pen.tap(view, {x, y});
        };
        QVERIFY(support::pressUntil(hasTurned, tapAll));
        QVERIFY(!view.isPressed());
        QVERIFY(!hasCut());
    }

private:
    using OtherStation = support::OtherStation;

    void takeHand()
    {
        QFETCH(const QString, device);
        window().activateWindow();
        WAIT_FOR(window().isActiveWindow());
        if (device == "mouse")
            m_hand = std::make_unique<MouseHand>(window());
        else if (device == "pen")
            m_hand = std::make_unique<PenHand>(window());
        else if (device == "keyboard")
            m_hand = std::make_unique<KeyHand>(window());
        else
            m_hand = std::make_unique<PadHand>(window(), window().devicesPage().pedals());
    }

    /// Returns the visible and enabled button of an action, or null.
    [[nodiscard]] QAbstractButton* buttonFor(const QAction& action) const
    {
        for (auto* button : window().findChildren<QAbstractButton*>())
            if (button->isVisible() && button->isEnabled() && button->accessibleName() == action.text())
                return button;
        return nullptr;
    }

    void doLessons(const std::vector<std::string>& ids, const QString& device)
    {
        startAs("sam");
        waitForPage<ui::catalog::LessonsPage>();
        takeHand();
        int done = 0;
        for (const std::string& lesson : ids) {
            doLesson(lesson);
            if (QTest::currentTestFailed())
                return;
            ++done;
            WAIT_FOR_VALUE(attempts(), done);
            const OtherStation elsewhere(place());
            QCOMPARE(elsewhere.ask("SELECT device FROM attempts ORDER BY id DESC LIMIT 1").toString(), device);
        }
    }

    /// Selects a lesson, works on it, grades it, and leaves the score page.
    void doLesson(const std::string& id)
    {
        startLesson(id);
        if (!QTest::currentTestFailed())
            finish();
        if (QTest::currentTestFailed())
            qWarning("%s: %s", id.c_str(), qPrintable(message()));
    }

    void startLesson(const std::string& id)
    {
        auto* const list = child<QListView>("lessonList");
        WAIT_FOR(list->isVisible() || buttonFor(*actions().lessons) != nullptr);
        if (!list->isVisible())
            m_hand->openLessons(*buttonFor(*actions().lessons));
        WAIT_FOR(list->isVisible());
        const lessons::Lesson lesson = shipped(id);
        const QString title = ui::text::said(lesson.title);
        WAIT_FOR(indexOf(*list, title).isValid());
        const std::uint64_t before = servo().toothGeneration;
        m_hand->start(*list, title, *child<QAbstractButton>("startLesson"));
        if (QTest::currentTestFailed())
            return;
        if (lesson.exam) {
            WAIT_FOR(child<QPushButton>("questionSave") != nullptr);
            m_hand->press(*child<QPushButton>("questionSave"));
        }
        WAIT_FOR(servo().toothGeneration > before);
        waitForTooth();
        work(lesson);
    }

    void finish()
    {
        // A message or a card may cover the button for a moment and take the first press.
        const auto isAsked = [&] { return child<ui::scoring::ScorePredictionPage>()->isVisible(); };
        const auto ask = [&] {
            closeCard();
            if (auto* const button = buttonFor(*actions().grade); button != nullptr && !isAsked())
                m_hand->grade(*button);
        };
        QVERIFY2(support::pressUntil(isAsked, ask), qPrintable(message()));
        m_hand->raiseSlider(*child<QSlider>("expected"));
        WAIT_FOR(child<QPushButton>("showScore")->isEnabled());
        m_hand->press(*child<QPushButton>("showScore"));
        WAIT_FOR(child<ui::scoring::ScorePage>()->isVisible());
        WAIT_FOR(buttonFor(*actions().back) != nullptr);
        m_hand->goBack(*buttonFor(*actions().back));
        WAIT_FOR(!child<ui::scoring::ScorePage>()->isVisible());
    }

    /// Closes the card of a rule violation, which takes the focus. On a slow computer it may appear while the bur is in
    /// the air.
    void closeCard()
    {
        if (auto* const goOn = child<QPushButton>("goOn"); goOn != nullptr && goOn->isVisible())
            m_hand->press(*goOn);
    }

    void work(const lessons::Lesson& lesson)
    {
        ui::tooth::ToothView& view = window().view();
        const bool cuts = !lessons::isExercise(lesson.task);
        const bool holds = lesson.task == lessons::Task::HoldForce;
        if (holds) {
            m_hand->raiseForce(*child<QSlider>("pushForce"));
            WAIT_FOR(view.hand().forceN() > 1.0);
        }
        // An exercise counts as begun when the assessment has seen it, which may be after the bur has reached the
        // tooth.
        const bool counts = !cuts && lesson.task != lessons::Task::TellLayers;
        const auto isThere = [&] {
            if (counts && !core::grading::isBegun(child<ui::practice::ExerciseCard>("exerciseCard")->practised()))
                return false;
            return cuts ? servo().removedMm3 != core::terrain::PerMaterial{} : servo().touching;
        };
        glm::dvec3 aim(0.0, 0.0, view.tooth() != nullptr ? -1.0 : 0.0);
        if (lesson.touch)  // the pit
            aim = glm::dvec3(lesson.touch->pointsMm.back(), aim.z);
        const glm::dvec2 place(aim);
        const auto push = [&] {
            if (view.isPressed()) {
                // Like a user who sees where the bur has come down, corrects the aim.
                aim += glm::dvec3(place - glm::dvec2(servo().anchorMm), 0.0);
                m_hand->lift(view);
            }
            closeCard();
            m_hand->push(view, aim);
        };
        QVERIFY2(support::pressUntil(isThere, push, kSecondPushMs), qPrintable(message()));
        if (holds)
            WAIT_FOR(glm::length(servo().forceN) > 0.8);
        waitForTicks(600);
        m_hand->lift(view);
        WAIT_FOR(!view.isPressed());
        if (lesson.task != lessons::Task::TellLayers)
            return;
        // The last answer of each pad can be reached as well.
        for (int pad = 0; pad < 3; ++pad) {
            auto* const answer = child<QAbstractButton>(
                qPrintable(QStringLiteral("pad%1%2").arg(pad).arg(static_cast<int>(core::terrain::Material::Caries))));
            m_hand->press(*answer);
            WAIT_FOR(answer->isChecked());
        }
    }

    static lessons::Lesson shipped(const std::string& id)
    {
        for (const lessons::CatalogEntry& entry : lessons::readCatalog(lessons::teachersFolder()))
            if (entry.read.lesson && entry.read.lesson->id == id)
                return *entry.read.lesson;
        qFatal("no such lesson: %s", id.c_str());
    }

    std::unique_ptr<Hand> m_hand;
};

int main(int argc, char** argv)
{
    return support::openGlMain<TestOneInput>(argc, argv);
}

#include "tst_one_input.moc"
