// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>

#include <QDateTime>
#include <QString>
#include <QStringList>

#include "core/base/Result.h"
#include "core/teeth/ToothBuilder.h"
#include "core/terrain/Tooth.h"
#include "lessons/ScoreSheet.h"

/// Codes and values of the rooms below, in words of the user's language. No other place in ui decides on such words.
namespace ui::text {

/// What could not be done.
enum class FailedOperation {
    OpeningScan,
    MakingTooth,
    OpeningLesson,
    OpeningRecording,
    SavingRecording,
    SavingReference,
    Marking,
    KeepingGrades,
    KeepingGrade,    ///< on the disk; it is tried again
    ReadingSchool,   ///< what is known of people, classes and attempts
    ChangingSchool,  ///< the same; nothing was changed
    Reporting,       ///< on paper or in a file, what of it is read for that
    SendingAttempt,  ///< to the school; it is damaged
    KeepingAttempt,  ///< on the disk, while it goes on
    KeepingExam,     ///< the same, of what cannot be saved by hand
    ResumingAttempt  ///< that was not finished
};

/// What happened, what still works and what to try, two or three sentences. The error's own detail (English, exact) is
/// for the log and for whoever asks.
[[nodiscard]] QString errorText(const core::Error& error, FailedOperation failed);
/// Why somebody could not log in, or be entered.
[[nodiscard]] QString loginFault(const core::Error& error);

/// What the importer guessed, left out or could not make sense of, one sentence each; empty when all is well.
[[nodiscard]] QStringList scanNotes(const core::teeth::ToothReport& report);

/// A time of today, or a day and a time, local.
[[nodiscard]] QString shortWhen(const QDateTime& at);

/// "enamel", "dentin", "decay", "pulp".
[[nodiscard]] QString materialName(core::terrain::Material material);
/// One letter that stands for the material where colour alone would not do.
[[nodiscard]] QString materialLetter(core::terrain::Material material);

/// "lower left first molar"; empty for a number that is not an FDI tooth.
[[nodiscard]] QString toothName(int fdi);
/// One or two letters for the sides of a tooth of the left half, in the order of the axes of its frame: -x mesial,
/// +x distal, -y, +y (cheek or lip, palate or tongue), -z (empty), +z occlusal or incisal. Empty for no tooth.
[[nodiscard]] QStringList surfaceLetters(int fdi);
/// "Tooth 36", "Practice block: cross", or the file's name for a scan without a number.
[[nodiscard]] QString toothTitle(const core::terrain::ToothAnatomy& tooth);

/// Where a direction square to the axis of a tooth points: "distal", "mesiobuccal"; of a scan, of which nobody knows
/// the sides, "+x", "−x +y".
/// @param angleRad  about +z of its own frame, 0 along +x
[[nodiscard]] QString sideName(const core::terrain::ToothAnatomy& tooth, double angleRad);
/// Where a horizontal direction of the frame a tooth is cut in points: as sideName() where it stands upright; on a side
/// also "incisal", "apical", "mesial / occlusal".
/// @param angleRad  about +z of that frame, 0 along +x
[[nodiscard]] QString directionName(const core::terrain::ToothAnatomy& tooth, double angleRad);
/// The two planes people ask for, as directionName() would have them: "Mesio-distal" and "Bucco-lingual", or "Along x"
/// and "Along y".
[[nodiscard]] QString planeAlongX(const core::terrain::ToothAnatomy& tooth);
[[nodiscard]] QString planeAlongY(const core::terrain::ToothAnatomy& tooth);

/// "Pear, No. 330"; the id itself for a bur we have no word for.
[[nodiscard]] QString burName(std::string_view id);
/// What a handpiece is called, by its name in settings; a name that is not known is said as it is.
[[nodiscard]] QString handpieceName(std::string_view name);

/// What a bit pattern of core::servo::Health means for the person drilling, the gravest first; empty when well.
[[nodiscard]] QString healthText(std::uint32_t health);

/// "Decay left": what the rubric calls it in the user's language; the measure's own name where it says nothing.
[[nodiscard]] QString criterionName(const lessons::Criterion& criterion);
/// "50 % of the decay is removed": what has to be done before a criterion earns anything.
[[nodiscard]] QString onceWords(const lessons::Once& once);
/// What "sound_tissue" counts, two sentences: the same beside the tooth and in the grade.
[[nodiscard]] QString soundTissueCounted();
/// "12.4 %", "1.84 mm³", "not measured".
[[nodiscard]] QString criterionMeasured(const lessons::Criterion& criterion);
/// The formula with its numbers: "(3.20 − 1.00 free) % / 30.00 × 60.0 points = 4.4".
[[nodiscard]] QString criterionWorked(const lessons::Criterion& criterion, lessons::Verdict verdict);
/// "100.0 − 4.4 − 12.0 − 0.0 = 83.6".
[[nodiscard]] QString scoreSum(const lessons::ScoreSheet& sheet);
/// Tenths of a point as the language writes them, always with one decimal: "83.6".
[[nodiscard]] QString points(int tenths);

/// "mm³" for "mm3", "mm²" for "mm2"; other units as they are.
[[nodiscard]] QString unitName(std::string_view unit);
/// A number with fixed decimals as the user's language writes it, with a true minus sign.
[[nodiscard]] QString number(double value, int decimals);
/// With a large first letter.
[[nodiscard]] QString capitalised(QString words);
/// Minutes and seconds: "1:07".
[[nodiscard]] QString duration(double seconds);
/// How a day is written without its year: "d MMM" as it is translated, in American English the month first.
[[nodiscard]] QString dayFormat(const QString& translated);

/// Which aids were in use, or that none was.
/// @param aids  bits of core::servo::Aid
[[nodiscard]] QString aidWords(std::uint64_t aids);

}  // namespace ui::text
