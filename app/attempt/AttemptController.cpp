// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/attempt/AttemptController.h"

#include <filesystem>
#include <span>
#include <utility>
#include <variant>

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QRandomGenerator>

#include "app/attempt/FeltSettings.h"
#include "app/threads/Background.h"
#include "core/grading/Measures.h"
#include "core/guidance/Fixture.h"
#include "core/history/MomentId.h"
#include "core/preparation/CapturedIdeal.h"
#include "core/settings/StabilityBound.h"
#include "core/teeth/Block.h"
#include "ui/render/WholeSurface.h"
#include "ui/text/ValidationTexts.h"
#include "ui/tooth/ToothView.h"
#include "ui/tooth/Viewpoint.h"

namespace app {
namespace {

using ui::text::FailedOperation;
using ui::window::MainWindow;

constexpr std::size_t kCommandsOfATooth = 16;  ///< another tooth comes with its bur, its aids and more
constexpr int kSpareTooth = 36;                ///< FDI number

/// Returns the notes on a scan, in the language of the moment.
std::function<QStringList()> notesOf(const core::teeth::ToothReport& report)
{
    return [report] { return ui::text::scanNotes(report); };
}

}  // namespace

AttemptController::AttemptController(const Parts& parts, const core::teeth::BuildOptions& build, bool isForPicture)
    : m_window(parts.window), m_channels(parts.channels), m_session(parts.session), m_assessment(parts.assessment),
      m_devices(parts.devices), m_presets(parts.presets), m_attempt(parts.attempt), m_loads(parts.loads),
      m_limit(parts.limit), m_build(build), m_isForPicture(isForPicture)
{
    connectTeeth();
    connectPresets();
    connect(&m_devices, &DeviceController::inUseChanged, this, &AttemptController::followHand);
    connect(&m_devices, &DeviceController::simulatedChanged, this, &AttemptController::beginForAnotherHand);
    connect(&m_window, &MainWindow::recordingSaveRequested, this, &AttemptController::saveRecording);
    connect(&m_window, &MainWindow::referenceSaveRequested, this, &AttemptController::saveReference);
    connect(&m_window, &MainWindow::takeBackRequested, this, &AttemptController::undoTo);
    connect(&m_window, &MainWindow::fixtureRequested, this, &AttemptController::guideHand);
    m_window.setHistorySource({[this] { return m_session.historySoFar(); },
                               [this](core::history::MomentId id) { return m_session.momentHeights(id); }});
}

void AttemptController::connectTeeth()
{
    connect(&m_window, &MainWindow::toothChosen, this, [this](int fdi) { openTooth({fdi}); });
    connect(&m_window, &MainWindow::lessonChosen, this, &AttemptController::openLesson);
    connect(&m_window, &MainWindow::scanChosen, this,
            [this](const QString& path) { openTooth({std::filesystem::path(path.toStdU16String())}); });
    connect(&m_window, &MainWindow::scanUnitChosen, this, [this](const QString& unit) {
        if (const auto known = core::mesh::parseUnit(unit.toStdString()))
            openTooth(m_source, *known);
    });
    connect(&m_window, &MainWindow::attemptAgainRequested, this, &AttemptController::beginAgain);
}

void AttemptController::connectPresets()
{
    connect(&m_window, &MainWindow::presetFelt, this, &AttemptController::feel);
    connect(&m_window, &MainWindow::feelRequested, this, &AttemptController::feelByHand);
    connect(&m_window, &MainWindow::presetTrialRequested, this, [this](const core::settings::FeelPreset& preset) {
        m_triedKind = {};
        openTooth(core::teeth::parseSource(core::teeth::blockName(core::teeth::BlockShape::Layers)), {}, preset);
    });
    connect(&m_window, &MainWindow::trialBlockChosen, this,
            [this](const core::settings::ToothKind& kind) { m_triedKind = kind; });
    connect(&m_presets, &PresetController::inUseChanged, this, [this] {
        m_byHand.reset();
        // An attempt that nobody has begun to work on begins anew with the preset in use.
        if (!m_attempt.assignment().lesson && !m_tried && !m_window.isBusy() && isUntouched())
            beginAsItFeels();
    });
    m_window.showFeel(m_presets.inUse(), m_presets.inUse());
}

void AttemptController::beginAgain()
{
    m_loads.begin();
    m_presets.readAgain();
    const auto again = [this, load = m_loads.latest()] {
        m_presets.whenRead([this, load] {
            if (!m_loads.isLatest(load))
                return;
            begin(lessons::Assignment(m_attempt.assignment()), {}, false);
            m_window.showBegunAnew();
        });
    };
    if (m_attempt.assignment().lesson)
        m_limit.whenAllowed(m_attempt.assignment().lesson->id, again);
    else
        again();
}

void AttemptController::openTooth(const core::teeth::ToothSource& source,
                                  const std::optional<core::mesh::LengthUnit>& unit,
                                  const std::optional<core::settings::FeelPreset>& tried)
{
    const int load = m_loads.begin();
    const auto* fdi = std::get_if<int>(&source.what);
    const auto* path = std::get_if<std::filesystem::path>(&source.what);
    const QString file = path == nullptr ? QString() : QFileInfo(*path).filePath();
    m_window.showBusy(fdi != nullptr    ? tr("Making tooth %1 …").arg(*fdi)
                      : path != nullptr ? tr("Reading %1 …").arg(QFileInfo(file).fileName())
                                        : tr("Making a practice block …"));
    core::teeth::BuildOptions build = m_build;
    if (unit)
        build.placement.unit = unit;
    m_presets.readAgain();
    inBackground(
        this,
        [source, build, workOut = surfaceWorker()] {
            auto built = core::teeth::buildTooth(source, build);
            if (built)
                workOut(built->anatomy);
            return built;
        },
        [this, load, source, file, tried](const core::Result<core::teeth::BuiltTooth>& built) {
            m_presets.whenRead([this, load, source, file, tried, built] {
                // What was asked for since does not end the wait for the program's first tooth: without one nothing
                // could be practised on.
                const bool isFirstWanted = load == 1 && !m_attempt.hasTooth() && !m_attempt.isResting();
                if (!m_loads.isLatest(load) && !isFirstWanted)
                    return;
                if (!built) {
                    refuse(built.error(), file.isEmpty() ? FailedOperation::MakingTooth : FailedOperation::OpeningScan,
                           file);
                    return;
                }
                m_source = source;
                m_tried = tried;
                if (!tried && file.isEmpty())  // a scan may be of somebody's patient
                    m_practised = built->anatomy;
                useTooth(*built);
                if (tried)
                    m_window.beginTrial();
            });
        });
}

void AttemptController::openLesson(const lessons::Lesson& lesson)
{
    const int load = m_loads.begin();
    m_window.showBusy(tr("Preparing the lesson …"));
    m_presets.readAgain();
    m_limit.whenAllowed(lesson.id, [this, load, lesson] {
        inBackground(
            this,
            [lesson, drawn = QRandomGenerator::global()->generate64(), workOut = surfaceWorker()] {
                auto assigned = lessons::assign(lesson, drawn);
                if (assigned)
                    workOut(assigned->assignment.anatomy);
                return assigned;
            },
            [this, load, id = lesson.id](const core::Result<lessons::Assigned>& assigned) {
                m_presets.whenRead([this, load, id, assigned] {
                    if (!m_loads.isLatest(load))
                        return;
                    if (!assigned) {
                        refuse(assigned.error(), FailedOperation::OpeningLesson, QString::fromStdString(id));
                        return;
                    }
                    m_tried.reset();
                    begin(assigned->assignment, notesOf(assigned->report), false);
                });
            });
    });
}

void AttemptController::beginWholeTooth()
{
    emit cleared();
    m_tried.reset();
    if (!m_attempt.hasTooth())  // it is still being made
        return;
    // The tooth of a lesson may have no decay to be taken out.
    if (const auto practice = lessons::practiceOn(m_practised ? m_practised : m_attempt.assignment().anatomy))
        begin(*practice, {}, false);
}

/// What is whole because it was undone could be redone, and what has a grade is an attempt already.
bool AttemptController::isUntouched() const
{
    const auto tooth = m_session.toothSoFar();
    return !m_attempt.isResting() && !m_attempt.isGraded() && tooth &&
           tooth->anatomy == m_attempt.assignment().anatomy && tooth->top == tooth->anatomy->top &&
           m_session.historySoFar().size() <= 1;
}

/// The same once more. What was found of a scan is not found again, and still to be answered.
void AttemptController::beginAsItFeels()
{
    begin(lessons::Assignment(m_attempt.assignment()), std::function<QStringList()>(m_notes), m_isUnitInDoubt);
}

/// In the middle of an attempt: what differs goes to the servo as numbers, and so onto the recording.
void AttemptController::feel(const core::settings::FeelPreset& preset)
{
    const lessons::Lesson* lesson = m_attempt.assignment().lesson ? &*m_attempt.assignment().lesson : nullptr;
    if (m_attempt.isResting() || (lesson != nullptr && lesson->exam) || !core::settings::checkStability(preset))
        return;
    m_parameters = core::servo::parametersOf(
        lessons::servoSettings(lesson, settingsFor(m_devices.isForceChosen(), m_devices.scale()), preset,
                               m_tried ? m_triedKind : core::settings::ToothKind{}));
    sendParameters();
}

/// What was turned in the console or the settings holds until it is turned back, for other teeth as well.
void AttemptController::feelByHand(const core::settings::FeelPreset& preset)
{
    core::settings::FeelPreset asKept = preset;
    asKept.hash = m_presets.inUse().hash;
    m_byHand = asKept == m_presets.inUse() ? std::nullopt : std::optional(preset);
    // An attempt that nobody has begun to work on is made with the whole preset, and says so.
    const bool isWhole = lessons::hashed(preset).hash == preset.hash;
    if (isWhole && isUntouched() && !m_attempt.assignment().exercise)
        beginAsItFeels();
    else
        feel(preset);
}

/// What the servo has not been told yet; the rest later, where there is no room.
void AttemptController::sendParameters()
{
    for (std::size_t k = 0; k < m_parameters.size(); ++k)
        if (m_parameters.at(k) != m_parametersSent.at(k)) {
            const core::servo::SetParameter number{static_cast<std::uint8_t>(k),
                                                   static_cast<float>(m_parameters.at(k))};
            if (!m_channels.commands.tryPush(number))
                return;
            m_parametersSent.at(k) = m_parameters.at(k);
        }
}

/// Said in the window, and if nothing lies on the table yet, a tooth of our own is put there. Where only a picture was
/// requested, the program ends.
void AttemptController::refuse(const core::Error& error, FailedOperation failed, const QString& file)
{
    if (m_isForPicture) {
        emit cannotGoOn(error);
        return;
    }
    m_window.showError(error, failed, file);
    if (!m_attempt.hasTooth() && !m_attempt.isResting())
        openTooth({kSpareTooth});
}

void AttemptController::useTooth(const core::teeth::BuiltTooth& built)
{
    const auto practice = lessons::practiceOn(built.anatomy);
    if (practice)
        begin(*practice, notesOf(built.report), built.report.placement.unitDoubtful);
    else
        refuse(practice.error(), FailedOperation::MakingTooth, {});
}

void AttemptController::begin(const lessons::Assignment& assignment, const std::function<QStringList()>& notes,
                              bool unitInDoubt)
{
    const bool isExam = assignment.lesson && assignment.lesson->exam;
    const core::settings::FeelPreset usual = m_tried.value_or(m_presets.inUse());
    const core::settings::FeelPreset preset = m_tried || isExam ? usual : m_byHand.value_or(m_presets.inUse());
    const core::servo::ServoSettings settings =
        lessons::servoSettings(assignment.lesson ? &*assignment.lesson : nullptr,
                               settingsFor(m_devices.isForceChosen(), m_devices.scale()), preset);
    auto servo = core::servo::makeServoTick(settings);
    if (!servo) {
        refuse(servo.error(), FailedOperation::OpeningLesson,
               assignment.lesson ? QString::fromStdString(assignment.lesson->id) : QString());
        return;
    }
    if (!canLoad())
        return;
    load(assignment, settings, notes, unitInDoubt);
    if (m_tried)
        emit nobodysBegun(m_attempt.generation());
    m_window.showFeel(preset, usual);
    m_window.send(core::session::ReplaceTooth{
        std::make_unique<core::terrain::Tooth>(m_attempt.assignment().anatomy), m_attempt.generation(),
        m_attempt.assignment().lesson ? m_attempt.assignment().lesson->json : "", std::move(*servo)});
}

bool AttemptController::canLoad()
{
    return m_window.canSend(kCommandsOfATooth);
}

AttemptController::SurfaceWorker AttemptController::surfaceWorker() const
{
    return [light = ui::tooth::operatingLight(m_window.view().isLeftHanded())](
               const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy) {
        ui::render::workOutSurface(anatomy, light);
    };
}

void AttemptController::load(const lessons::Assignment& assignment, const core::servo::ServoSettings& settings,
                             const std::function<QStringList()>& notes, bool unitInDoubt)
{
    emit aboutToLoad();
    m_attempt.begin(nextGeneration(), assignment, settings);
    m_notes = notes;
    m_isUnitInDoubt = unitInDoubt;
    m_parameters = core::servo::parametersOf(m_attempt.settings());
    m_parametersSent = m_parameters;
    m_window.setAssignment(m_attempt.assignment());
    m_window.setHandpieces(m_attempt.settings().handpieces);
    guideHand(false);
    m_assessment.watch(m_attempt.generation(), lessons::examinationOf(m_attempt.assignment()));
    emit loaded();
    m_window.showTooth(m_attempt.assignment().anatomy, m_attempt.generation(), notes, unitInDoubt);
}

void AttemptController::followHand()
{
    // An attempt that nobody has worked on begins anew, so that it feels as the device can make it felt.
    const core::contact::ForceSettings felt = settingsFor(m_devices.isForceChosen(), m_devices.scale()).force;
    if (!m_devices.isSimulated() && m_attempt.settings().force.workAreaMm != felt.workAreaMm && !m_attempt.isExam() &&
        !m_attempt.assignment().exercise && !m_window.isBusy() && isUntouched())
        beginAsItFeels();
}

/// The user has chosen the simulated hand, whose work is nobody's, or has left it.
void AttemptController::beginForAnotherHand()
{
    m_loads.begin();
    const std::optional<lessons::Lesson> lesson = m_attempt.assignment().lesson;
    if (m_devices.isSimulated()) {
        emit becameNobodys();
        if (lesson && lesson->exam)
            beginWholeTooth();
        else if (m_attempt.assignment().anatomy)
            beginAsItFeels();
    } else {
        const std::uint64_t nobodys = m_attempt.generation();
        beginWholeTooth();
        emit becameSomebodys(nobodys);
        if (lesson && !lesson->exam)
            openLesson(*lesson);
    }
    m_window.showBegunAnew();
}

/// Within the outline of what is to be cut, or nowhere.
void AttemptController::guideHand(bool wanted)
{
    const core::grading::IdealTop ideal = wanted ? m_attempt.assignment().shownIdeal() : nullptr;
    std::unique_ptr<const core::guidance::Fixture> fixture;
    if (ideal)
        fixture = std::make_unique<const core::guidance::Fixture>(*m_attempt.assignment().anatomy, *ideal);
    m_window.send(core::session::SetFixture{std::move(fixture)});
}

/// To the last moment before a tick, on the way that led here.
void AttemptController::undoTo(std::uint64_t tick)
{
    if (const auto last = core::history::lastBefore(m_session.historySoFar(), tick))
        static_cast<void>(m_channels.commands.tryPush(core::session::GoTo{*last}));
}

void AttemptController::saveRecording(const QString& path)
{
    const auto recording = m_session.recordingSoFar();
    if (!recording)
        return;
    inBackground(
        this,
        [recording = *recording, path] {
            return core::recording::writeRecording(std::filesystem::path(path.toStdU16String()), recording);
        },
        [this, path](const core::Status& written) {
            if (written)
                m_window.showSaved(path);
            else
                m_window.showError(written.error(), FailedOperation::SavingRecording, path);
        });
}

/// The tooth as it stands, as an ideal for lessons to ask for.
void AttemptController::saveReference(const QString& path)
{
    const auto tooth = m_session.toothSoFar();
    if (!tooth)
        return;
    inBackground(
        this,
        [tooth = *tooth, path] {
            const core::terrain::Tooth* const one = &tooth;
            const auto ideal = core::preparation::capture(
                std::span(&one, 1), {},
                {"an attempt of " + QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString()});
            return ideal ? core::preparation::writeCaptured(std::filesystem::path(path.toStdU16String()), *ideal)
                         : core::Status(tl::unexpected(ideal.error()));
        },
        [this, path](const core::Status& written) {
            if (written)
                m_window.showMessage(tr("The reference was saved as %1. A lesson names it, or choose it in the editor "
                                        "of a lesson on this tooth.")
                                         .arg(QDir::toNativeSeparators(path)));
            else
                m_window.showError(written.error(), FailedOperation::SavingReference, path);
        });
}

}  // namespace app
