// SPDX-License-Identifier: GPL-3.0-or-later
// Hardness presets of a school on fake repositories: two admins change them at once, another user logs in before an
// answer, or the connection is lost.
#include <memory>

#include <QSignalSpy>
#include <QStandardPaths>
#include <QTest>

#include "app/pages/PresetController.h"
#include "app/pages/SchoolPresets.h"
#include "core/session/SessionChannels.h"
#include "lessons/PresetShelf.h"
#include "tests/app/FakeSchool.h"
#include "tests/database/SchoolRig.h"
#include "ui/window/MainWindow.h"

using core::ErrorCode;
using core::settings::FeelPreset;

namespace {

/// Returns a preset of this name. Different numbers give different values.
FeelPreset presetCalled(const char* name, int number = 1)
{
    FeelPreset preset = lessons::shippedPresets().front();
    preset.name = name;
    preset.version = 0;
    preset.notes = "number " + std::to_string(number);
    preset.stiffnessNPerMm = 1.0 + 0.1 * number;
    return preset;
}

std::string nameOf(const FeelPreset& preset)
{
    return preset.name + " v" + std::to_string(preset.version);
}

}  // namespace

class TestPresetController : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        // Only the database makes logins.
        const support::SchoolRig rig(support::populatedSchool(false));
        m_admin = rig.admin;
        m_student = rig.student;
    }
    void init() { m_school = std::make_unique<support::FakeSchool>(); }

    void savesTheNextVersion()
    {
        QCOMPARE(app::savePreset(m_school->all(), m_admin, presetCalled("mine", 1))->version, 1);
        QCOMPARE(app::savePreset(m_school->all(), m_admin, presetCalled("mine", 2))->version, 2);
        QCOMPARE(app::savePreset(m_school->all(), m_admin, presetCalled("mine", 2))->version, 2);  // exists already
        QCOMPARE(m_school->presets.all.size(), std::size_t{2});
    }

    void takesTheVersionAfterThatOfAnotherStation()
    {
        m_school->presets.beforeAdd = [this] {
            m_school->presets.beforeAdd = [] {};
            QCOMPARE(app::savePreset(m_school->all(), m_admin, presetCalled("mine", 1))->version, 1);
        };
        QCOMPARE(app::savePreset(m_school->all(), m_admin, presetCalled("mine", 2))->version, 2);
        QCOMPARE(m_school->presets.all.size(), std::size_t{2});
    }

    void returnsWhyAPresetCannotBeSaved()
    {
        m_school->presets.refusal = core::Error{ErrorCode::NotAllowed, "admins only"};
        QCOMPARE(app::savePreset(m_school->all(), m_student, presetCalled("mine")).error().code, ErrorCode::NotAllowed);
    }

    void retiringKeepsWhatAnotherAdminRetires()
    {
        m_school->settings.beforeReplace = [this] {
            m_school->settings.beforeReplace = [] {};
            m_school->settings.all[database::kRetiredPresets] = "other";
        };
        QCOMPARE(app::retirePreset(m_school->all(), m_admin, "mine", true).value(), true);
        QCOMPARE(m_school->settings.all[database::kRetiredPresets], std::string("other\nmine"));
    }

    void retiringGivesUpWhenOthersKeepChanging()
    {
        int changes = 0;
        m_school->settings.beforeReplace = [&] {
            m_school->settings.all[database::kRetiredPresets] = "other" + std::to_string(++changes);
        };
        QCOMPARE(app::retirePreset(m_school->all(), m_admin, "mine", true).error().code, ErrorCode::Busy);
        QVERIFY(changes > 1);
    }

    void thePresetInUseIsNotRetired()
    {
        m_school->settings.all[database::kPresetInUse] = "mine v2";
        QCOMPARE(app::retirePreset(m_school->all(), m_admin, "mine", true).value(), false);
        QVERIFY(m_school->settings.all[database::kRetiredPresets].empty());
    }

    void aChosenPresetIsOfferedAgain()
    {
        m_school->settings.all[database::kRetiredPresets] = "mine\nother";
        const auto chosen = app::choosePreset(m_school->all(), m_admin, "mine v1", {}).value();
        QVERIFY(chosen.isDone && chosen.wasRetired && chosen.before.empty());
        QCOMPARE(m_school->settings.all[database::kPresetInUse], std::string("mine v1"));
        QCOMPARE(m_school->settings.all[database::kRetiredPresets], std::string("other"));
    }

    void theChoiceOfAnotherAdminStays()
    {
        m_school->settings.all[database::kPresetInUse] = "other v1";
        const auto chosen = app::choosePreset(m_school->all(), m_admin, "mine v1", QString("first v1")).value();
        QVERIFY(!chosen.isDone);
        QCOMPARE(chosen.before, std::string("other v1"));
        QCOMPARE(m_school->settings.all[database::kPresetInUse], std::string("other v1"));
    }

    void usesThePresetOfTheSchool()
    {
        makeController(m_student);
        QSignalSpy changed(m_presets.get(), &app::PresetController::inUseChanged);
        chooseInSchool("mine");
        m_presets->refresh();
        QCOMPARE(changed.count(), 0);
        m_school->answer();
        QCOMPARE(changed.count(), 1);
        QCOMPARE(nameOf(m_presets->inUse()), std::string("mine v1"));
    }

    void anAnswerForAnotherUserIsDropped()
    {
        makeController(m_student);
        chooseInSchool("mine");
        const std::string before = nameOf(m_presets->inUse());
        m_presets->refresh();
        m_who = m_admin;
        m_school->answer();
        QCOMPARE(nameOf(m_presets->inUse()), before);
    }

    void anOutageKeepsThePresetInUse()
    {
        makeController(m_student);
        chooseInSchool("mine");
        m_presets->refresh();
        m_school->answer();
        m_school->outage = core::Error{ErrorCode::ConnectionLost, "the server is away"};
        m_presets->readAgain();
        m_school->answer();
        QCOMPARE(nameOf(m_presets->inUse()), std::string("mine v1"));
    }

    void loadingWaitsForTheAnswer()
    {
        makeController(m_student);
        m_presets->readAgain();
        int loads = 0;
        m_presets->whenRead([&loads] { ++loads; });
        QCOMPARE(loads, 0);
        m_school->answer();
        QCOMPARE(loads, 1);
        m_presets->whenRead([&loads] { ++loads; });
        QCOMPARE(loads, 2);
    }

    void aSavedPresetIsInTheSchool()
    {
        makeController(m_admin);
        emit m_window->hardness().saveRequested(presetCalled("mine"));
        m_school->answer();
        QCOMPARE(m_school->presets.all.size(), std::size_t{1});
        QCOMPARE(m_school->presets.all.front().name, std::string("mine"));
    }

    void cleanup()
    {
        m_presets.reset();
        m_window.reset();
    }

private:
    void makeController(const database::Login& who)
    {
        m_who = who;
        m_window = std::make_unique<ui::window::MainWindow>(m_links);
        m_presets = std::make_unique<app::PresetController>(*m_window, [this] { return m_who; });
        m_presets->setSchool(m_school.get());
        m_school->answer();
    }
    /// Saves a preset from another station and selects it for the school.
    void chooseInSchool(const char* name)
    {
        QVERIFY(app::savePreset(m_school->all(), m_admin, presetCalled(name)));
        QVERIFY(app::choosePreset(m_school->all(), m_admin, QString(name) + " v1", {})->isDone);
    }

    database::Login m_admin;
    database::Login m_student;
    database::Login m_who;
    core::session::UiChannels m_links;
    std::unique_ptr<support::FakeSchool> m_school;
    std::unique_ptr<ui::window::MainWindow> m_window;
    std::unique_ptr<app::PresetController> m_presets;
};

QTEST_MAIN(TestPresetController)
#include "tst_preset_controller.moc"
