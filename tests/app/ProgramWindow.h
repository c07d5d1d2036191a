// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include <QDeadlineTimer>
#include <QObject>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <glm/vec3.hpp>

#include "app/Application.h"
#include "core/servo/ServoState.h"
#include "lessons/Lesson.h"
#include "ui/kit/Actions.h"
#include "ui/kit/MessageBar.h"
#include "ui/kit/TabularDigitsLabel.h"

/// QTRY_VERIFY and QTRY_COMPARE with a timeout that is long enough for a window on a busy machine.
#define WAIT_FOR(condition) QTRY_VERIFY2_WITH_TIMEOUT(condition, qPrintable(message()), support::kPatienceMs)
#define WAIT_FOR_VALUE(actual, expected) QTRY_COMPARE_WITH_TIMEOUT(actual, expected, support::kPatienceMs)

class QLabel;

namespace support {

constexpr int kPatienceMs = 60000;

/// Time without an answer after which a person presses again.
constexpr int kSecondTryMs = 3000;

/// Repeats an action until it has worked. Returns whether it has, within kPatienceMs.
/// @param tryMs  how long each try may take to work
template <class Condition, class Try>
[[nodiscard]] bool pressUntil(const Condition& hasWorked, const Try& press, int tryMs = kSecondTryMs)
{
    for (const QDeadlineTimer patience(kPatienceMs); !hasWorked() && !patience.hasExpired();) {
        press();
        if (QTest::currentTestFailed())
            return false;
        (void)QTest::qWaitFor(hasWorked, tryMs);
    }
    return hasWorked();
}

/// The whole program with its window and a folder of its own: the base of the tests that use the program as a user
/// does.
class ProgramWindow : public QObject
{
protected:
    /// Makes the program and shows its window. Of the options only the database is completed, if it is empty.
    void begin(app::WindowOptions options);
    void waitForTooth() const { WAIT_FOR(actions().grade->isEnabled()); }
    template <class T>
    T* child(const char* name = "") const
    {
        return window().findChild<T*>(QString::fromLatin1(name));
    }
    [[nodiscard]] ui::window::MainWindow& window() const { return m_application->window(); }
    [[nodiscard]] ui::kit::Actions& actions() const { return *child<ui::kit::Actions>(); }
    template <class Page>
    void waitForPage() const
    {
        WAIT_FOR(child<Page>()->isVisible());
    }
    /// Asks for the grade until the page is there: the last motion of the hand may not be counted at the first request.
    template <class Page>
    void gradeUntil() const
    {
        const auto isThere = [this] { return child<Page>()->isVisible(); };
        QVERIFY2(pressUntil(isThere, [this] { actions().grade->trigger(); }), qPrintable(message()));
    }
    /// Returns the text in the message bar.
    [[nodiscard]] QString message() const { return child<ui::kit::MessageBar>()->sentence(); }
    void waitForMessage(const QString& words) const { WAIT_FOR(message().contains(words)); }
    /// Returns the volume of removed enamel that the window shows.
    [[nodiscard]] QString removed() const { return child<ui::kit::TabularDigitsLabel>("enamelRemoved")->text(); }
    /// Waits until the button is enabled, and clicks it.
    void click(const char* button) const;
    /// Goes back, step by step, to a page that was open before.
    template <class Page>
    void goBackTo() const
    {
        const auto isThere = [this] {
            if (!child<Page>()->isVisible())
                actions().back->trigger();
            return child<Page>()->isVisible();
        };
        WAIT_FOR(isThere());
    }
    /// Returns the visible label, anywhere in the window, that contains these words; null if there is none.
    [[nodiscard]] const QLabel* labelWith(const QString& words) const;

    /// Presses the mouse button over a point of the tooth. Returns the position of the pointer in the view.
    QPoint press(glm::dvec3 pointMm) const;
    void release() const;
    /// Presses until something is removed, releases, and waits until the stroke has ended.
    void drill(glm::dvec3 pointMm) const;
    void drill(double xMm) const { drill({xMm, 1.0, -1.0}); }
    /// Returns the servo state that the window showed last.
    [[nodiscard]] const core::servo::ServoState& servo() const { return m_servo; }
    [[nodiscard]] bool hasCut() const { return m_removed != core::terrain::PerMaterial{}; }
    void waitForTicks(std::uint64_t ticks) const;
    /// Waits until the work of the pointer has ended as a stroke.
    void waitForStrokeEnd() const;
    /// Makes a change that puts another tooth on the table, and waits until the servo has it.
    void waitForNewTooth(const std::function<void()>& change) const;
    void openLesson(const lessons::Lesson& lesson) const;
    /// Writes a lesson, reads it and opens it.
    void openMadeLesson(std::string_view json) const;
    /// Opens a shipped lesson, or one in the teacher's folder.
    lessons::Lesson openLesson(const std::string& id) const;
    /// Answers the question before the score, which must be shown.
    void expectScore() const;
    /// Returns the unfinished attempts in the station's folder, or in a folder below its "unfinished".
    [[nodiscard]] QStringList journals(const QString& below = {}) const;
    /// Ends the program, and leaves its one unfinished attempt as a killed program leaves it. Returns the path.
    QString killWithJournal(const QString& below = {});

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<app::Application> m_application;

private:
    core::servo::ServoState m_servo;
    std::uint64_t m_cutAtTick = 0;           ///< when material was removed last
    core::terrain::PerMaterial m_removed{};  ///< up to then
};

}  // namespace support
