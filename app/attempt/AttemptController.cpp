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
#include "core/recording/OriginNotes.h"
#include "core/settings/StabilityBound.h"
#include "core/teeth/Block.h"
#include "ui/kit/Actions.h"
#include "ui/render/WholeSurface.h"
#include "ui/text/ScanNotes.h"
#include "ui/text/ValidationTexts.h"
#include "ui/tooth/ToothView.h"
#include "ui/tooth/Viewpoint.h"

namespace app {
namespace {

using ui::text::FailedOperation;
using ui::window::MainWindow;

constexpr std::size_t kCommandsOfATooth = 16;  ///< another tooth comes with its bur, its aids and more
constexpr int kSpareTooth = 36;                ///< FDI number

/// Returns a function that gives the notes on a scan in the current language.
std::function<QStringList()> notesOf(const core::teeth::ToothReport& report)
{
    return [report] { return ui::text::scanNotes(report); };
}

}  // namespace

AttemptController::AttemptController(const AttemptContext& context, const core::teeth::BuildOptions& build,
                                     bool isForPicture)
    : m_context(context), m_build(build), m_isForPicture(isForPicture)
{
    connectTeeth();
    connectPresets();
    connect(&m_context.devices, &DeviceController::inUseChanged, this, &AttemptController::followHand);
    connect(&m_context.devices, &DeviceController::simulatedChanged, this, &AttemptController::beginForAnotherHand);
    connect(&m_context.window.unsavedWork(), &ui::window::UnsavedWork::recordingSaveRequested, this,
            &AttemptController::saveRecording);
    connect(&m_context.window, &MainWindow::referenceSaveRequested, this, &AttemptController::saveReference);
    connect(&m_context.window.infractionView(), &ui::window::InfractionView::takeBackRequested, this,
            &AttemptController::undoTo);
    connect(m_context.window.actions().fixture, &QAction::triggered, this, &AttemptController::guideHand);
    m_context.window.setHistorySource(
        {[this] { return m_context.session.historySoFar(); },
         [this](core::history::MomentId id) { return m_context.session.momentHeights(id); }});
}

void AttemptController::connectTeeth()
{
    connect(&m_context.window, &MainWindow::toothChosen, this, [this](int fdi) { openTooth({fdi}); });
    connect(&m_context.window, &MainWindow::lessonChosen, this, &AttemptController::openLesson);
    connect(&m_context.window, &MainWindow::scanChosen, this,
            [this](const QString& path) { openTooth({std::filesystem::path(path.toStdU16String())}); });
    connect(&m_context.window, &MainWindow::scanUnitChosen, this, [this](const QString& unit) {
        if (const auto known = core::mesh::parseUnit(unit.toStdString()))
            openTooth(m_source, *known);
    });
    connect(&m_context.window.lessonController(), &ui::window::LessonController::attemptAgainRequested, this,
            &AttemptController::beginAgain);
}

void AttemptController::connectPresets()
{
    connect(&m_context.window.hardness(), &ui::window::HardnessController::trialFelt, this, &AttemptController::feel);
    connect(&m_context.window.hardness(), &ui::window::HardnessController::feelRequested, this,
            &AttemptController::feelByHand);
    connect(&m_context.window.hardness(), &ui::window::HardnessController::trialRequested, this,
            [this](const core::settings::FeelPreset& preset) {
                m_triedKind = {};
                openTooth(core::teeth::parseSource(core::teeth::blockName(core::teeth::BlockShape::Layers)), {},
                          preset);
            });
    connect(&m_context.window.hardness(), &ui::window::HardnessController::trialBlockChosen, this,
            [this](const core::settings::ToothKind& kind) { m_triedKind = kind; });
    connect(&m_context.presets, &PresetController::inUseChanged, this, [this] {
        m_byHand.reset();
        // An attempt without any work begins again with the new preset.
        if (!m_context.attempt.assignment().lesson && !m_tried && !m_context.window.isBusy() && isUntouched())
            beginAsItFeels();
    });
    m_context.window.hardness().setFeel(m_context.presets.inUse(), m_context.presets.inUse());
}

void AttemptController::beginAgain()
{
    m_context.loads.begin();
    m_context.presets.readAgain();
    const auto again = [this, load = m_context.loads.latest()] {
        m_context.presets.whenRead([this, load] {
            if (!m_context.loads.isLatest(load))
                return;
            begin(lessons::Assignment(m_context.attempt.assignment()), {}, false);
            m_context.window.lessonController().showBegunAgain();
        });
    };
    if (m_context.attempt.assignment().lesson)
        m_context.limit.whenAllowed(m_context.attempt.assignment().lesson->id, again);
    else
        again();
}

void AttemptController::openTooth(const core::teeth::ToothSource& source,
                                  const std::optional<core::mesh::LengthUnit>& unit,
                                  const std::optional<core::settings::FeelPreset>& tried)
{
    const int load = m_context.loads.begin();
    const auto* fdi = std::get_if<int>(&source.what);
    const auto* path = std::get_if<std::filesystem::path>(&source.what);
    const QString file = path == nullptr ? QString() : QFileInfo(*path).filePath();
    m_context.window.showBusy(fdi != nullptr    ? tr("Making tooth %1 …").arg(*fdi)
                              : path != nullptr ? tr("Reading %1 …").arg(QFileInfo(file).fileName())
                                                : tr("Making a practice block …"));
    core::teeth::BuildOptions build = m_build;
    if (unit)
        build.placement.unit = unit;
    m_context.presets.readAgain();
    inBackground(
        this,
        [source, build, workOut = surfaceWorker()] {
            auto built = core::teeth::buildTooth(source, build);
            if (built)
                workOut(built->anatomy);
            return built;
        },
        [this, load, source, file, tried](const core::Result<core::teeth::BuiltTooth>& built) {
            m_context.presets.whenRead([this, load, source, file, tried, built] {
                // A later request does not cancel the program's first tooth: if it fails, there would be no tooth.
                const bool isFirstWanted = load == 1 && !m_context.attempt.hasTooth() && !m_context.attempt.isResting();
                if (!m_context.loads.isLatest(load) && !isFirstWanted)
                    return;
                if (!built) {
                    refuse(built.error(), file.isEmpty() ? FailedOperation::MakingTooth : FailedOperation::OpeningScan,
                           file);
                    return;
                }
                m_source = source;
                m_tried = tried;
                if (!tried && file.isEmpty())  // a scan may show somebody's patient
                    m_practised = built->anatomy;
                useTooth(*built);
                if (tried)
                    m_context.window.beginTrial();
            });
        });
}

void AttemptController::openLesson(const lessons::Lesson& lesson)
{
    const int load = m_context.loads.begin();
    m_context.window.showBusy(tr("Preparing the lesson …"));
    m_context.presets.readAgain();
    m_context.limit.whenAllowed(lesson.id, [this, load, lesson] {
        inBackground(
            this,
            [lesson, drawn = QRandomGenerator::global()->generate64(), workOut = surfaceWorker()] {
                auto assigned = lessons::assign(lesson, drawn);
                if (assigned)
                    workOut(assigned->assignment.anatomy);
                return assigned;
            },
            [this, load, id = lesson.id](const core::Result<lessons::Assigned>& assigned) {
                m_context.presets.whenRead([this, load, id, assigned] {
                    if (!m_context.loads.isLatest(load))
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
    if (!m_context.attempt.hasTooth())  // it is still being made
        return;
    // The tooth of a lesson may have no decay, so the tooth practised on before comes first.
    if (const auto practice = lessons::practiceOn(m_practised ? m_practised : m_context.attempt.assignment().anatomy))
        begin(*practice, {}, false);
}

/// The history decides: a tooth that is whole after an undo has been worked on.
bool AttemptController::isUntouched() const
{
    const auto tooth = m_context.session.toothSoFar();
    return !m_context.attempt.isResting() && !m_context.attempt.isGraded() && tooth &&
           tooth->anatomy == m_context.attempt.assignment().anatomy && tooth->top == tooth->anatomy->top &&
           m_context.session.historySoFar().size() <= 1;
}

/// Begins the same attempt again with the preset in use. Keeps the notes on a scan: it is not read again.
void AttemptController::beginAsItFeels()
{
    begin(lessons::Assignment(m_context.attempt.assignment()), std::function<QStringList()>(m_notes), m_isUnitInDoubt);
}

/// Changes the hardness during an attempt: sends the servo the parameters that differ. The recording contains them.
void AttemptController::feel(const core::settings::FeelPreset& preset)
{
    const lessons::Lesson* lesson =
        m_context.attempt.assignment().lesson ? &*m_context.attempt.assignment().lesson : nullptr;
    if (m_context.attempt.isResting() || (lesson != nullptr && lesson->exam) || !core::settings::checkStability(preset))
        return;
    m_parameters = core::servo::parametersOf(
        lessons::servoSettings(lesson, settingsFor(m_context.devices.isForceChosen(), m_context.devices.scale()),
                               preset, m_tried ? m_triedKind : core::settings::ToothKind{}));
    sendParameters();
}

/// Uses a preset that the user changed in console or settings, also for later teeth, until they change it back.
void AttemptController::feelByHand(const core::settings::FeelPreset& preset)
{
    core::settings::FeelPreset asKept = preset;
    asKept.hash = m_context.presets.inUse().hash;
    m_byHand = asKept == m_context.presets.inUse() ? std::nullopt : std::optional(preset);
    // An attempt without any work begins again, so that it names the preset it was made with.
    const bool isWhole = lessons::hashed(preset).hash == preset.hash;
    if (isWhole && isUntouched() && !m_context.attempt.assignment().exercise)
        beginAsItFeels();
    else
        feel(preset);
}

/// Stops where the channel is full; AttemptObserver calls it again.
void AttemptController::sendParameters()
{
    for (std::size_t k = 0; k < m_parameters.size(); ++k)
        if (m_parameters.at(k) != m_parametersSent.at(k)) {
            const core::servo::SetParameter number{static_cast<std::uint8_t>(k),
                                                   static_cast<float>(m_parameters.at(k))};
            if (!m_context.channels.commands.tryPush(number))
                return;
            m_parametersSent.at(k) = m_parameters.at(k);
        }
}

/// Ends the program instead if only a picture was requested.
void AttemptController::refuse(const core::Error& error, FailedOperation failed, const QString& file)
{
    if (m_isForPicture) {
        emit cannotGoOn(error);
        return;
    }
    m_context.window.showError(error, failed, file);
    if (!m_context.attempt.hasTooth() && !m_context.attempt.isResting())
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
    const core::settings::FeelPreset usual = m_tried.value_or(m_context.presets.inUse());
    const core::settings::FeelPreset preset = m_tried || isExam ? usual : m_byHand.value_or(m_context.presets.inUse());
    const core::servo::ServoSettings settings =
        lessons::servoSettings(assignment.lesson ? &*assignment.lesson : nullptr,
                               settingsFor(m_context.devices.isForceChosen(), m_context.devices.scale()), preset);
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
        emit nobodysBegun(m_context.attempt.generation());
    m_context.window.hardness().setFeel(preset, usual);
    m_context.window.send(core::session::ReplaceTooth{
        std::make_unique<core::terrain::Tooth>(m_context.attempt.assignment().anatomy), m_context.attempt.generation(),
        m_context.attempt.assignment().lesson ? m_context.attempt.assignment().lesson->json : "", std::move(*servo)});
    notePerson();
}

void AttemptController::notePerson()
{
    const database::Login& user = m_context.school.user;
    if (!user.isGuest() && !m_context.devices.isSimulated())
        m_context.window.send(core::session::AddNote{core::recording::personNote(user.uid())});
}

bool AttemptController::canLoad()
{
    return m_context.window.canSend(kCommandsOfATooth);
}

AttemptController::SurfaceWorker AttemptController::surfaceWorker() const
{
    return [light = ui::tooth::operatingLight(m_context.window.view().isLeftHanded())](
               const std::shared_ptr<const core::terrain::ToothAnatomy>& anatomy) {
        ui::render::workOutSurface(anatomy, light);
    };
}

void AttemptController::load(const lessons::Assignment& assignment, const core::servo::ServoSettings& settings,
                             const std::function<QStringList()>& notes, bool unitInDoubt)
{
    emit aboutToLoad();
    m_context.attempt.begin(nextGeneration(), assignment, settings);
    m_notes = notes;
    m_isUnitInDoubt = unitInDoubt;
    m_parameters = core::servo::parametersOf(m_context.attempt.settings());
    m_parametersSent = m_parameters;
    m_context.window.setAssignment(m_context.attempt.assignment());
    m_context.window.setHandpieces(m_context.attempt.settings().handpieces);
    guideHand(false);
    m_context.assessment.watch(m_context.attempt.generation(), lessons::examinationOf(m_context.attempt.assignment()));
    emit loaded();
    m_context.window.showTooth(m_context.attempt.assignment().anatomy, m_context.attempt.generation(), notes,
                               unitInDoubt);
}

void AttemptController::followHand()
{
    // The settings of the force depend on the device. An attempt without any work begins again with the new ones.
    const core::contact::ForceSettings felt =
        settingsFor(m_context.devices.isForceChosen(), m_context.devices.scale()).force;
    if (!m_context.devices.isSimulated() && m_context.attempt.settings().force.workAreaMm != felt.workAreaMm &&
        !m_context.attempt.isExam() && !m_context.attempt.assignment().exercise && !m_context.window.isBusy() &&
        isUntouched())
        beginAsItFeels();
}

/// Begins another attempt: the user has chosen the simulated hand, whose work belongs to nobody, or has left it.
void AttemptController::beginForAnotherHand()
{
    m_context.loads.begin();
    const std::optional<lessons::Lesson> lesson = m_context.attempt.assignment().lesson;
    if (m_context.devices.isSimulated()) {
        emit becameNobodys();
        if (lesson && lesson->exam)
            beginWholeTooth();
        else if (m_context.attempt.assignment().anatomy)
            beginAsItFeels();
    } else {
        const std::uint64_t nobodys = m_context.attempt.generation();
        beginWholeTooth();
        emit becameSomebodys(nobodys);
        if (lesson && !lesson->exam)
            openLesson(*lesson);
    }
    m_context.window.lessonController().showBegunAgain();
}

/// Switches the force that holds the hand within the ideal on or off.
void AttemptController::guideHand(bool wanted)
{
    const core::grading::IdealTop ideal = wanted ? m_context.attempt.assignment().shownIdeal() : nullptr;
    std::unique_ptr<const core::guidance::Fixture> fixture;
    if (ideal)
        fixture = std::make_unique<const core::guidance::Fixture>(*m_context.attempt.assignment().anatomy, *ideal);
    m_context.window.send(core::session::SetFixture{std::move(fixture)});
}

/// Undoes to the last moment before a tick.
void AttemptController::undoTo(std::uint64_t tick)
{
    if (const auto last = core::history::lastBefore(m_context.session.historySoFar(), tick))
        m_context.window.send(core::session::GoTo{*last});
}

void AttemptController::saveRecording(const QString& path)
{
    const auto recording = m_context.session.recordingSoFar();
    if (!recording)
        return;
    inBackground(
        this,
        [recording = *recording, path] {
            return core::recording::writeRecording(std::filesystem::path(path.toStdU16String()), recording);
        },
        [this, path](const core::Status& written) {
            if (written)
                m_context.window.showSaved(path);
            else
                m_context.window.showError(written.error(), FailedOperation::SavingRecording, path);
        });
}

/// Saves the tooth as it is now as a captured ideal for lessons.
void AttemptController::saveReference(const QString& path)
{
    const auto tooth = m_context.session.toothSoFar();
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
                m_context.window.showMessage(
                    tr("The reference was saved as %1. A lesson names it, or choose it in the editor "
                       "of a lesson on this tooth.")
                        .arg(QDir::toNativeSeparators(path)));
            else
                m_context.window.showError(written.error(), FailedOperation::SavingReference, path);
        });
}

}  // namespace app
