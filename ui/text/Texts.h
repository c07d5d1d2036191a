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

/// Texts for codes and values of the lower layers, in the user's language. Only this file defines these texts.
namespace ui::text {

/// The operation that failed.
enum class FailedOperation {
    OpeningScan,
    MakingTooth,
    OpeningLesson,
    OpeningRecording,
    SavingRecording,
    SavingReference,
    Marking,
    KeepingGrades,
    KeepingGrade,    ///< saving a grade to the disk; it is retried
    ReadingSchool,   ///< reading people, classes or attempts
    ChangingSchool,  ///< writing people, classes or attempts; no change was made
    Reporting,       ///< printing or exporting, including what must be read for it
    SendingAttempt,  ///< sending an attempt to the database; the attempt is damaged
    KeepingAttempt,  ///< saving an unfinished attempt to the disk
    KeepingExam,     ///< the same for an exam, which the user cannot save
    ResumingAttempt  ///< resuming an unfinished attempt
};

/// Returns what happened, what still works and what to try, in two or three sentences. The detail of the error
/// (English, exact) is not included; it is for the log and for tooltips.
[[nodiscard]] QString errorText(const core::Error& error, FailedOperation failed);
/// Returns why a person could not log in or be added.
[[nodiscard]] QString loginFault(const core::Error& error);

/// Returns a local time today, or a local day and time.
[[nodiscard]] QString shortWhen(const QDateTime& at);

/// Returns "enamel", "dentin", "decay" or "pulp".
[[nodiscard]] QString materialName(core::terrain::Material material);
/// Returns a letter that identifies the material where colour alone is not enough.
[[nodiscard]] QString materialLetter(core::terrain::Material material);

/// Returns a name such as "lower left first molar"; empty for a number that is not an FDI tooth.
[[nodiscard]] QString toothName(int fdi);
/// Returns one or two letters for each side of a tooth of the left half, in the order of its axes: -x mesial, +x
/// distal, -y and +y (cheek or lip, palate or tongue), -z (empty), +z occlusal or incisal. Empty if there is no tooth.
[[nodiscard]] QStringList surfaceLetters(int fdi);
/// Returns "Tooth 36", "Practice block: cross", or the file name of a scan without a number.
[[nodiscard]] QString toothTitle(const core::terrain::ToothAnatomy& tooth);

/// Returns the name of a direction perpendicular to the axis of a tooth: "distal", "mesiobuccal". For a scan with
/// unknown sides: "+x", "−x +y".
/// @param angleRad  about +z of the tooth's own frame, 0 along +x
[[nodiscard]] QString sideName(const core::terrain::ToothAnatomy& tooth, double angleRad);
/// Returns the name of a horizontal direction in the frame in which a tooth is cut. For an upright tooth it is that of
/// sideName(). For a tooth on its side it may also be "incisal", "apical" or "mesial / occlusal".
/// @param angleRad  about +z of that frame, 0 along +x
[[nodiscard]] QString directionName(const core::terrain::ToothAnatomy& tooth, double angleRad);
/// Return the names of the two usual planes in the terms of directionName(): "Mesio-distal" and "Bucco-lingual", or
/// "Along x" and "Along y".
[[nodiscard]] QString planeAlongX(const core::terrain::ToothAnatomy& tooth);
[[nodiscard]] QString planeAlongY(const core::terrain::ToothAnatomy& tooth);

/// Returns a name such as "Pear, No. 330"; the id itself for a bur without a name.
[[nodiscard]] QString burName(std::string_view id);
/// Returns the displayed name of a handpiece by its name in settings; an unknown name is returned unchanged.
[[nodiscard]] QString handpieceName(std::string_view name);

/// Returns the meaning of core::servo::Health bits for the user, the most severe first. Empty if no bit is set.
[[nodiscard]] QString healthText(std::uint32_t health);

/// Returns the title that the rubric gives a criterion in the user's language, otherwise the name of its measure:
/// "Decay left".
[[nodiscard]] QString criterionName(const lessons::Criterion& criterion);
/// Returns the condition under which a criterion earns points: "50 % of the decay is removed".
[[nodiscard]] QString onceWords(const lessons::Once& once);
/// Returns two sentences that explain what "sound_tissue" measures, for the panel beside the tooth and the score page.
[[nodiscard]] QString soundTissueCounted();
/// Returns the measured value: "12.4 %", "1.84 mm³", "not measured".
[[nodiscard]] QString criterionMeasured(const lessons::Criterion& criterion);
/// Returns the formula with its numbers: "(3.20 − 1.00 free) % / 30.00 × 60.0 points = 4.4".
[[nodiscard]] QString criterionWorked(const lessons::Criterion& criterion, lessons::Verdict verdict);
/// Returns the sum of a score: "100.0 − 4.4 − 12.0 − 0.0 = 83.6".
[[nodiscard]] QString scoreSum(const lessons::ScoreSheet& sheet);
/// Returns tenths of a point in the user's language, always with one decimal: "83.6".
[[nodiscard]] QString points(int tenths);

/// Returns "mm³" for "mm3" and "mm²" for "mm2"; other units unchanged.
[[nodiscard]] QString unitName(std::string_view unit);
/// Returns a number with fixed decimals in the user's language, with a true minus sign.
[[nodiscard]] QString number(double value, int decimals);
/// Returns the text with a capital first letter.
[[nodiscard]] QString capitalised(QString words);
/// Returns minutes and seconds: "1:07".
[[nodiscard]] QString duration(double seconds);
/// Returns the format of a date without its year: the translated "d MMM", but with the month first in American English.
[[nodiscard]] QString dayFormat(const QString& translated);

/// Returns the aids that were in use, or that none was.
/// @param aids  bits of core::servo::Aid
[[nodiscard]] QString aidWords(std::uint64_t aids);

}  // namespace ui::text
