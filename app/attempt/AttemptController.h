// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include <QObject>
#include <QString>
#include <QStringList>

#include "app/attempt/AttemptContext.h"
#include "core/servo/ServoParameters.h"
#include "core/teeth/ToothBuilder.h"
#include "lessons/Assignment.h"
#include "ui/text/Texts.h"

namespace app {

/// Begins attempts: at a tooth, a scan, a block or a lesson, with the preset in use and the hand that holds the bur.
/// Sends the session and the servo what they need for it. Ui thread.
class AttemptController final : public QObject
{
    Q_OBJECT

public:
    /// @param isForPicture  the program draws one picture and quits: it ends where the window would show an error
    AttemptController(const AttemptContext& context, const core::teeth::BuildOptions& build, bool isForPicture);

    /// Makes or reads a tooth, and begins an attempt without a lesson.
    /// @param unit   of a scan; empty: as found
    /// @param tried  the preset that is tried on the tooth; such an attempt belongs to nobody and is not saved
    void openTooth(const core::teeth::ToothSource& source, const std::optional<core::mesh::LengthUnit>& unit = {},
                   const std::optional<core::settings::FeelPreset>& tried = {});
    /// Makes the tooth of a lesson and begins an attempt, if the student has one left.
    void openLesson(const lessons::Lesson& lesson);
    /// Begins an attempt.
    /// @param notes  on the scan, in the language of the moment
    void begin(const lessons::Assignment& assignment, const std::function<QStringList()>& notes, bool isUnitInDoubt);
    /// Begins an attempt at the tooth practised on last, without a lesson. Forgets the last grade and the opened score.
    void beginWholeTooth();
    /// Adds a note to the recording that names the user. Does nothing for a guest and for the simulated hand.
    void notePerson();
    /// Makes an assignment the current attempt and shows its tooth. The caller sends the session its command next.
    void load(const lessons::Assignment& assignment, const core::servo::ServoSettings& settings,
              const std::function<QStringList()>& notes, bool isUnitInDoubt);
    /// Shows an error. If there is no tooth yet, a spare one is made.
    void refuse(const core::Error& error, ui::text::FailedOperation failed, const QString& file);

    /// Whether nobody has worked on the current attempt. Work that was undone could be redone, and a graded attempt is
    /// complete.
    [[nodiscard]] bool isUntouched() const;
    /// Whether a preset is tried on the current tooth.
    [[nodiscard]] bool isTrial() const { return m_tried.has_value(); }
    void endTrial() { m_tried.reset(); }
    /// Forgets the preset that the user changed by hand.
    void forgetFeelByHand() { m_byHand.reset(); }
    /// Returns the number of the next tooth that is shown, in an attempt or in a replay.
    [[nodiscard]] std::uint64_t nextGeneration() { return ++m_generation; }
    /// Sends the servo the changed parameters that it has not been sent yet, as far as there is room.
    void sendParameters();
    /// Whether the commands of a new tooth can be sent now. Otherwise the window says that nothing was done.
    [[nodiscard]] bool canLoad();

    /// Prepares the drawing of a tooth. For the thread that makes or reads it: so the window does not wait.
    using SurfaceWorker = std::function<void(const std::shared_ptr<const core::terrain::ToothAnatomy>&)>;
    [[nodiscard]] SurfaceWorker surfaceWorker() const;

signals:
    /// Emitted before another attempt takes the place of the current one.
    void aboutToLoad();
    /// Emitted when another attempt is the current one, before the window shows its tooth.
    void loaded();
    /// Emitted before a whole tooth takes the place of work that belongs to the user before.
    void cleared();
    /// Emitted when an attempt begins that belongs to nobody, because a preset is tried.
    void nobodysBegun(std::uint64_t generation);
    /// Emitted when the simulated hand was chosen: work belongs to nobody from now on.
    void becameNobodys();
    /// Emitted when the simulated hand was left.
    /// @param nobodys  generation of the last tooth that it worked on
    void becameSomebodys(std::uint64_t nobodys);
    /// Emitted instead of showing an error, where only a picture was requested.
    void cannotGoOn(const core::Error& error);

private:
    void connectTeeth();
    void connectPresets();
    void beginAgain();
    void beginAsItFeels();
    void followHand();
    void feel(const core::settings::FeelPreset& preset);
    void feelByHand(const core::settings::FeelPreset& preset);
    void useTooth(const core::teeth::BuiltTooth& built);
    void beginForAnotherHand();
    void guideHand(bool wanted);
    void undoTo(std::uint64_t tick);
    void saveRecording(const QString& path);
    void saveReference(const QString& path);

    AttemptContext m_context;
    core::teeth::BuildOptions m_build;
    bool m_isForPicture;

    core::teeth::ToothSource m_source;  ///< of the tooth loaded last
    /// The tooth practised on last without a lesson. Never a scan: it may show somebody's patient.
    std::shared_ptr<const core::terrain::ToothAnatomy> m_practised;
    std::optional<core::settings::FeelPreset> m_tried;   ///< the preset on trial, instead of the one in use
    core::settings::ToothKind m_triedKind;               ///< the tissue of the trial's block
    std::optional<core::settings::FeelPreset> m_byHand;  ///< the preset as the user changed it; not used in exams
    core::servo::ServoParameters m_parameters{};         ///< the values that the servo should have
    core::servo::ServoParameters m_parametersSent{};     ///< the values that it has been sent
    std::function<QStringList()> m_notes;                ///< on the scan that was opened
    bool m_isUnitInDoubt = false;                        ///< the unit of that scan was guessed
    std::uint64_t m_generation = 0;                      ///< of the newest tooth shown
};

}  // namespace app
