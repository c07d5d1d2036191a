// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/Texts.h"

#include <array>
#include <cmath>
#include <numbers>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>

#include "core/bur/Bur.h"
#include "core/servo/ServoState.h"
#include "core/teeth/Block.h"
#include "core/teeth/ToothTable.h"

namespace ui::text {
namespace {

QString quadrantName(int quadrant)
{
    switch (quadrant) {
    case 1:
        return QCoreApplication::translate("Tooth", "upper right");
    case 2:
        return QCoreApplication::translate("Tooth", "upper left");
    case 3:
        return QCoreApplication::translate("Tooth", "lower left");
    case 4:
        return QCoreApplication::translate("Tooth", "lower right");
    default:
        return {};
    }
}

QString kindName(int position)
{
    switch (position) {
    case 1:
        return QCoreApplication::translate("Tooth", "%1 central incisor");
    case 2:
        return QCoreApplication::translate("Tooth", "%1 lateral incisor");
    case 3:
        return QCoreApplication::translate("Tooth", "%1 canine");
    case 4:
        return QCoreApplication::translate("Tooth", "%1 first premolar");
    case 5:
        return QCoreApplication::translate("Tooth", "%1 second premolar");
    case 6:
        return QCoreApplication::translate("Tooth", "%1 first molar");
    case 7:
        return QCoreApplication::translate("Tooth", "%1 second molar");
    case 8:
        return QCoreApplication::translate("Tooth", "%1 third molar");
    default:
        return {};
    }
}

/// Returns the advice for a file that cannot be used.
QString remedy(FailedOperation failed)
{
    switch (failed) {
    case FailedOperation::OpeningScan:
        return QCoreApplication::translate("Error", "Export it again, or choose another scan.");
    case FailedOperation::OpeningRecording:
        return QCoreApplication::translate("Error", "Copy it again from where it was made, or choose another one.");
    case FailedOperation::KeepingGrades:
    case FailedOperation::KeepingGrade:
    case FailedOperation::ReadingSchool:
    case FailedOperation::ChangingSchool:
    case FailedOperation::Reporting:
        return QCoreApplication::translate("Error", "Put a copy of it back, or move it away: Cusp then begins a new "
                                                    "one.");
    case FailedOperation::ResumingAttempt:
        return QCoreApplication::translate("Error", "Its file is kept for seven days, in the folder \"discarded\".");
    case FailedOperation::OpeningLesson:
        return QCoreApplication::translate("Error", "Ask who made the lesson, or choose another one.");
    case FailedOperation::MakingTooth:
    case FailedOperation::SavingRecording:
    case FailedOperation::SavingReference:
    case FailedOperation::Marking:
    case FailedOperation::KeepingAttempt:
    case FailedOperation::KeepingExam:
    case FailedOperation::SendingAttempt:
        return QCoreApplication::translate("Error", "Try again.");
    }
    return {};
}

/// Returns the message about a file of the wrong kind.
QString wrongKind(FailedOperation failed)
{
    switch (failed) {
    case FailedOperation::OpeningRecording:
        return QCoreApplication::translate("Error", "The file is no recording of Cusp.");
    case FailedOperation::KeepingGrades:
    case FailedOperation::KeepingGrade:
    case FailedOperation::ReadingSchool:
    case FailedOperation::ChangingSchool:
    case FailedOperation::Reporting:
        return QCoreApplication::translate("Error", "The file is no database of Cusp.");
    case FailedOperation::ResumingAttempt:
        return QCoreApplication::translate("Error", "This Cusp did not write the file, or an older one did.");
    case FailedOperation::OpeningScan:
    case FailedOperation::OpeningLesson:
    case FailedOperation::MakingTooth:
    case FailedOperation::SavingRecording:
    case FailedOperation::SavingReference:
    case FailedOperation::Marking:
    case FailedOperation::KeepingAttempt:
    case FailedOperation::KeepingExam:
    case FailedOperation::SendingAttempt:
        return QCoreApplication::translate("Error", "The file is not what its name says. Scans are OBJ, STL or PLY.");
    }
    return {};
}

QString unwritable(FailedOperation failed)
{
    if (failed == FailedOperation::KeepingGrade)  // the grade waits there until it is uploaded
        return QCoreApplication::translate("Error", "The folder “outbox”, where grades wait for the school, "
                                                    "cannot be written. Make room on the disk, or make that "
                                                    "folder writable.");
    if (failed == FailedOperation::KeepingGrades || failed == FailedOperation::ReadingSchool ||
        failed == FailedOperation::ChangingSchool || failed == FailedOperation::Reporting)
        return QCoreApplication::translate("Error", "The school's file cannot be written. Make room on the disk, "
                                                    "or make its folder writable.");
    return QCoreApplication::translate("Error", "The file cannot be written. Choose another folder, or make room "
                                                "on the disk.");
}

QString tooLarge(FailedOperation failed)
{
    if (failed == FailedOperation::OpeningScan)
        return QCoreApplication::translate("Error", "The file is too large. Export it with fewer triangles.");
    return QCoreApplication::translate("Error", "The file is too large.");
}

QString connectionLost(FailedOperation failed)
{
    if (failed == FailedOperation::ChangingSchool ||
        failed == FailedOperation::Reporting)  // Cusp does not retry these by itself
        return QCoreApplication::translate(
            "Error", "The school's server does not answer. Try it again when the server answers.");
    return QCoreApplication::translate("Error", "The school's server does not answer. Cusp tries again by itself.");
}

QString openElsewhere()
{
    return QCoreApplication::translate(
        "Error", "The school's data lie on a network drive, and another Cusp, here or at another computer, has them "
                 "open. Only one at a time can: close that one. For several computers an admin keeps them on a "
                 "PostgreSQL server.");
}

QString serverUnknown()
{
    return QCoreApplication::translate("Error", "The school's server cannot prove that it is the right one, or cannot "
                                                "encrypt the connection, so nothing is sent to it. Ask whoever looks "
                                                "after it to set up its certificate.");
}

QString reason(core::ErrorCode code, FailedOperation failed)
{
    const auto andRemedy = [failed](const QString& fault) { return fault + u' ' + remedy(failed); };
    switch (code) {
    case core::ErrorCode::FileMissing:
        return QCoreApplication::translate("Error", "The file is not there. Was it moved or renamed?");
    case core::ErrorCode::FileUnreadable:
        return QCoreApplication::translate("Error", "The file cannot be read. Check that it is a file and that you may "
                                                    "open it.");
    case core::ErrorCode::FileUnwritable:
        return unwritable(failed);
    case core::ErrorCode::FileEmpty:
        return andRemedy(QCoreApplication::translate("Error", "The file is empty."));
    case core::ErrorCode::FileTruncated:
        return andRemedy(QCoreApplication::translate("Error", "The file ends too early."));
    case core::ErrorCode::FileTooLarge:
        return tooLarge(failed);
    case core::ErrorCode::WrongKind:
        return wrongKind(failed);
    case core::ErrorCode::NewerVersion:
        return QCoreApplication::translate("Error", "A newer Cusp wrote this file. Update Cusp to open it.");
    case core::ErrorCode::OlderVersion:
        return QCoreApplication::translate(
            "Error", "An older Cusp made this school. Ask its administrator to run “cusp db migrate”.");
    case core::ErrorCode::BadNumber:
        return andRemedy(
            QCoreApplication::translate("Error", "Where a number belongs, the file holds something else."));
    case core::ErrorCode::BadStructure:
        return andRemedy(QCoreApplication::translate("Error", "The content of the file does not fit together."));
    case core::ErrorCode::NoTriangles:
        return QCoreApplication::translate("Error", "There is no surface in this file. Choose a scan of a tooth.");
    case core::ErrorCode::UnknownName:
        return QCoreApplication::translate("Error", "Cusp does not know what is asked for by this name.");
    case core::ErrorCode::OutOfRange:
        return QCoreApplication::translate("Error", "A value lies outside what Cusp can work with.");
    case core::ErrorCode::OtherTooth:
        return QCoreApplication::translate("Error", "It was made on another tooth, or with another decay, than this "
                                                    "lesson's. Ask who made the lesson.");
    case core::ErrorCode::Busy:
        return QCoreApplication::translate(
            "Error", "Another program is writing to the school's database. Try again in a moment.");
    case core::ErrorCode::OpenElsewhere:
        return openElsewhere();
    case core::ErrorCode::ConnectionLost:
        return connectionLost(failed);
    case core::ErrorCode::OutcomeUnknown:
        return QCoreApplication::translate("Error",
                                           "The school's server went away while this was being done, and nobody "
                                           "can say whether it was. Look when it answers again, before you do "
                                           "it again.");
    case core::ErrorCode::ServerRefuses:
        return QCoreApplication::translate("Error", "The school's server says no. Ask whoever looks after it: its log, "
                                                    "or “cusp db check”, says why.");
    case core::ErrorCode::ServerUnknown:
        return serverUnknown();
    case core::ErrorCode::OtherSchool:
        return QCoreApplication::translate(
            "Error", "Your login has ended, or another school is now where yours was. Log in again.");
    case core::ErrorCode::NotAllowed:
        return QCoreApplication::translate("Error", "Your role does not allow it.");
    case core::ErrorCode::Disabled:
        return QCoreApplication::translate("Error", "This account was disabled. Ask an admin.");
    case core::ErrorCode::NobodyLeft:
        return QCoreApplication::translate("Error",
                                           "This is the last admin who can log in. Make somebody else an admin first.");
    case core::ErrorCode::WrongLogin:
        return QCoreApplication::translate("Error", "Wrong username or password.");
    case core::ErrorCode::TooSoon:
        return QCoreApplication::translate("Error", "Too many logins have failed. Wait a moment and try again.");
    case core::ErrorCode::NewPassword:
        return QCoreApplication::translate("Error", "Choose a password first.");
    case core::ErrorCode::ChangedSince:
        return QCoreApplication::translate("Error",
                                           "Somebody else has changed it meanwhile. Here is what there is now; "
                                           "change it again if need be.");
    }
    return {};
}

}  // namespace

QString errorText(const core::Error& error, FailedOperation failed)
{
    if (error.code == core::ErrorCode::OutcomeUnknown)  // the operation may have succeeded
        return reason(error.code, failed);
    switch (failed) {
    case FailedOperation::OpeningScan:
        //: %1: why, and what to do
        return QCoreApplication::translate("Error", "The scan cannot be opened. %1").arg(reason(error.code, failed));
    case FailedOperation::MakingTooth:
        //: %1: why, and what to do
        return QCoreApplication::translate("Error", "The tooth cannot be created. %1").arg(reason(error.code, failed));
    case FailedOperation::OpeningLesson:
        //: %1: why, and what to do
        return QCoreApplication::translate("Error", "The lesson cannot be started; your work is unchanged. %1")
            .arg(reason(error.code, failed));
    case FailedOperation::Marking:
        //: %1: why, and what to do
        return QCoreApplication::translate("Error", "The work cannot be graded; it is unchanged. %1")
            .arg(reason(error.code, failed));
    case FailedOperation::OpeningRecording:
        //: %1: why, and what to do
        return QCoreApplication::translate("Error", "The recording cannot be played. %1")
            .arg(reason(error.code, failed));
    case FailedOperation::SavingRecording:
        //: %1: why, and what to do
        return QCoreApplication::translate("Error", "The recording was not saved. %1").arg(reason(error.code, failed));
    case FailedOperation::SavingReference:
        if (error.code == core::ErrorCode::BadStructure)
            return QCoreApplication::translate("Error", "Nothing has been cut yet that could be a reference.");
        //: %1: why, and what to do
        return QCoreApplication::translate("Error", "The reference was not saved. %1").arg(reason(error.code, failed));
    case FailedOperation::KeepingGrades:
        //: %1: why, and what to do
        return QCoreApplication::translate("Error", "Grades will not be saved; drilling and grading still work. %1")
            .arg(reason(error.code, failed));
    case FailedOperation::KeepingGrade:
        //: %1: why, and what to do
        return QCoreApplication::translate("Error", "This grade is not saved yet; Cusp tries again while it runs. %1")
            .arg(reason(error.code, failed));
    case FailedOperation::ReadingSchool:
        //: %1: why, and what to do
        return QCoreApplication::translate("Error", "The school's data cannot be shown now; your work is saved. %1")
            .arg(reason(error.code, failed));
    case FailedOperation::ChangingSchool:
        //: %1: why, and what to do
        return QCoreApplication::translate("Error", "That was not done, and nothing was changed. %1")
            .arg(reason(error.code, failed));
    case FailedOperation::Reporting:
        //: %1: why, and what to do
        return QCoreApplication::translate("Error", "Nothing was written: what stands on it is read anew for it. %1")
            .arg(reason(error.code, failed));
    case FailedOperation::SendingAttempt:
        return QCoreApplication::translate("Error",
                                           "An attempt that was to be sent to the school is damaged. It was moved to "
                                           "the folder “outbox/damaged”. Everything else is saved as usual.");
    case FailedOperation::KeepingAttempt:
    case FailedOperation::KeepingExam:
        if (error.code == core::ErrorCode::FileUnwritable && failed == FailedOperation::KeepingExam)
            return QCoreApplication::translate(
                "Error", "This attempt is not kept on the disk while you work: if the computer fails, it is lost. Go "
                         "on, and have room made on the disk.");
        if (error.code == core::ErrorCode::FileUnwritable)
            return QCoreApplication::translate(
                "Error", "This attempt is not kept on the disk while you work: if the computer fails, it is lost. "
                         "Make room on the disk, or save the recording now and then.");
        //: %1: why, and what to do
        return QCoreApplication::translate("Error", "This attempt is not kept on the disk while you work. %1")
            .arg(reason(error.code, failed));
    case FailedOperation::ResumingAttempt:
        //: %1: why, and what to do
        return QCoreApplication::translate("Error", "An unfinished attempt cannot be resumed. %1")
            .arg(reason(error.code, failed));
    }
    return QString::fromStdString(error.detail);
}

QString loginFault(const core::Error& error)
{
    switch (error.code) {
    case core::ErrorCode::WrongLogin:
        return QCoreApplication::translate(
            "Login", "Wrong username or password. Try again, or ask an admin for a one-time code.");
    case core::ErrorCode::TooSoon: {
        // The detail contains one number, the seconds to wait.
        static const QRegularExpression kNumber(QStringLiteral("\\d+"));
        const int seconds = kNumber.match(QString::fromStdString(error.detail)).captured().toInt();
        return QCoreApplication::translate("Login", "Too many logins have failed. Wait %n second(s) and try again.",
                                           nullptr, seconds);
    }
    case core::ErrorCode::OutOfRange:
        return QCoreApplication::translate("Login", "A password has at least eight characters, does not contain the "
                                                    "username and is not a common one such as \"password1\".");
    case core::ErrorCode::NotAllowed:
        return QCoreApplication::translate("Login", "A user was added here in the meantime. Log in as an admin.");
    case core::ErrorCode::ConnectionLost:
        return QCoreApplication::translate("Login", "The school's server does not answer. Try again, or practise "
                                                    "without a login.");
    case core::ErrorCode::Busy:
        return QCoreApplication::translate(
            "Login",
            "Another program is writing to the school's database, so nobody can log in. Try again in a moment.");
    default:
        return errorText(error, FailedOperation::KeepingGrades);
    }
}

QString shortWhen(const QDateTime& at)
{
    const QLocale locale;
    return at.date() == QDate::currentDate() ? locale.toString(at.time(), QLocale::ShortFormat)
                                             : locale.toString(at, QLocale::ShortFormat);
}

QString materialName(core::terrain::Material material)
{
    switch (material) {
    case core::terrain::Material::Caries:
        return QCoreApplication::translate("Material", "decay");
    case core::terrain::Material::Enamel:
        return QCoreApplication::translate("Material", "enamel");
    case core::terrain::Material::Dentin:
        return QCoreApplication::translate("Material", "dentin");
    case core::terrain::Material::Pulp:
        return QCoreApplication::translate("Material", "pulp");
    }
    return {};
}

QString materialLetter(core::terrain::Material material)
{
    switch (material) {
    case core::terrain::Material::Caries:
        //: One letter for decay (caries); must differ from those of enamel, dentin and pulp.
        return QCoreApplication::translate("Material", "C");
    case core::terrain::Material::Enamel:
        //: One letter for enamel
        return QCoreApplication::translate("Material", "E");
    case core::terrain::Material::Dentin:
        //: One letter for dentin
        return QCoreApplication::translate("Material", "D");
    case core::terrain::Material::Pulp:
        //: One letter for pulp
        return QCoreApplication::translate("Material", "P");
    }
    return {};
}

QString toothName(int fdi)
{
    const QString quadrant = quadrantName(fdi / 10);
    const QString kind = kindName(fdi % 10);
    return quadrant.isEmpty() || kind.isEmpty() ? QString() : kind.arg(quadrant);
}

QStringList surfaceLetters(int fdi)
{
    if (toothName(fdi).isEmpty())
        return {};
    const bool upper = fdi < 30;
    const bool front = fdi % 10 <= 3;
    //: Letters for sides of teeth, one or two each. Mesial
    const QString mesial = QCoreApplication::translate("Surface", "M");
    //: Letter for the distal side
    const QString distal = QCoreApplication::translate("Surface", "D");
    //: Letters for the labial side (towards the lip), then for the buccal one (towards the cheek)
    const QString facial =
        front ? QCoreApplication::translate("Surface", "La") : QCoreApplication::translate("Surface", "B");
    //: Letters for the palatal side, then for the lingual one
    const QString inner =
        upper ? QCoreApplication::translate("Surface", "P") : QCoreApplication::translate("Surface", "L");
    //: Letters for the incisal edge, then for the occlusal surface
    const QString top =
        front ? QCoreApplication::translate("Surface", "I") : QCoreApplication::translate("Surface", "O");
    return {mesial, distal, upper ? inner : facial, upper ? facial : inner, QString(), top};
}

namespace {

/// Returns "Practice block: cross", or an empty string if the name is not of a block.
QString blockTitle(const std::string& name)
{
    const auto block = core::teeth::findBlock(name);
    if (!block || !*block)
        return {};
    switch ((*block)->shape) {
    case core::teeth::BlockShape::Line:
        return QCoreApplication::translate("Block", "Practice block: line");
    case core::teeth::BlockShape::Circle:
        return QCoreApplication::translate("Block", "Practice block: circle");
    case core::teeth::BlockShape::Cross:
        return QCoreApplication::translate("Block", "Practice block: cross");
    case core::teeth::BlockShape::Square:
        return QCoreApplication::translate("Block", "Practice block: square");
    case core::teeth::BlockShape::Dovetail:
        return QCoreApplication::translate("Block", "Practice block: dovetail");
    case core::teeth::BlockShape::Staircase:
        return QCoreApplication::translate("Block", "Practice block: staircase");
    case core::teeth::BlockShape::Bar:
        return QCoreApplication::translate("Block", "Practice block: letter I");
    case core::teeth::BlockShape::Tee:
        return QCoreApplication::translate("Block", "Practice block: letter T");
    case core::teeth::BlockShape::Plunges:
        return QCoreApplication::translate("Block", "Practice block: depth plunges");
    case core::teeth::BlockShape::Junction:
        return QCoreApplication::translate("Block", "Practice block: enamel and dentin");
    case core::teeth::BlockShape::Layers:
        break;
    }
    return QCoreApplication::translate("Block", "Practice block: three layers");
}

}  // namespace

QString toothTitle(const core::terrain::ToothAnatomy& tooth)
{
    if (QString block = blockTitle(tooth.name); !block.isEmpty())
        return block;
    const QString name = QString::fromStdString(tooth.name);
    if (tooth.fdi != 0 && (name.isEmpty() || name == QString::number(tooth.fdi)))
        return QCoreApplication::translate("Tooth", "Tooth %1").arg(tooth.fdi);
    return name.isEmpty() ? QCoreApplication::translate("Tooth", "Tooth without a name") : name;
}

QString sideName(const core::terrain::ToothAnatomy& tooth, double angleRad)
{
    const auto eighth = static_cast<int>(std::lround(angleRad / (std::numbers::pi / 4.0)));
    const int sector = ((eighth % 8) + 8) % 8;
    constexpr std::array<int, 8> kX{1, 1, 0, -1, -1, -1, 0, 1};
    const int x = kX.at(static_cast<std::size_t>(sector));
    const int y = kX.at(static_cast<std::size_t>((sector + 6) % 8));
    if (!core::teeth::isGenerated(tooth)) {
        const auto axis = [](int sign, QChar name) {
            return sign == 0 ? QString() : (sign > 0 ? QStringLiteral("+") : QString(QChar(0x2212))) + name;
        };
        return QStringLiteral("%1 %2").arg(axis(x, u'x'), axis(y, u'y')).trimmed();
    }
    const bool front = tooth.fdi % 10 <= 3;
    const bool upper = tooth.fdi / 10 == 2;
    const bool outwards = static_cast<double>(y) * core::teeth::buccalSign(tooth.fdi) > 0.0;
    // Whole words, because other languages combine them differently.
    const auto outer = [&](const QString& labial, const QString& buccal) { return front ? labial : buccal; };
    const auto inner = [&](const QString& palatal, const QString& lingual) { return upper ? palatal : lingual; };
    const auto say = [](const char* word) { return QCoreApplication::translate("Direction", word); };
    if (y == 0)
        return x > 0 ? say(QT_TRANSLATE_NOOP("Direction", "distal")) : say(QT_TRANSLATE_NOOP("Direction", "mesial"));
    if (x == 0)
        return outwards
                   ? outer(say(QT_TRANSLATE_NOOP("Direction", "labial")), say(QT_TRANSLATE_NOOP("Direction", "buccal")))
                   : inner(say(QT_TRANSLATE_NOOP("Direction", "palatal")),
                           say(QT_TRANSLATE_NOOP("Direction", "lingual")));
    if (x > 0)
        return outwards ? outer(say(QT_TRANSLATE_NOOP("Direction", "distolabial")),
                                say(QT_TRANSLATE_NOOP("Direction", "distobuccal")))
                        : inner(say(QT_TRANSLATE_NOOP("Direction", "distopalatal")),
                                say(QT_TRANSLATE_NOOP("Direction", "distolingual")));
    return outwards ? outer(say(QT_TRANSLATE_NOOP("Direction", "mesiolabial")),
                            say(QT_TRANSLATE_NOOP("Direction", "mesiobuccal")))
                    : inner(say(QT_TRANSLATE_NOOP("Direction", "mesiopalatal")),
                            say(QT_TRANSLATE_NOOP("Direction", "mesiolingual")));
}

QString directionName(const core::terrain::ToothAnatomy& tooth, double angleRad)
{
    if (tooth.lying.isUpright())
        return sideName(tooth, angleRad);
    // Every axis of the tooth within 67.5 degrees of the direction, as for an upright tooth.
    constexpr double kLeastShare = 0.3827;
    const glm::dvec3 own =
        glm::transpose(tooth.lying.cutFromOwn()) * glm::dvec3(std::cos(angleRad), std::sin(angleRad), 0.0);
    const bool isKnown = core::teeth::isGenerated(tooth);
    QStringList names;
    if (std::abs(own.x) > kLeastShare)
        names << sideName(tooth, own.x > 0.0 ? 0.0 : std::numbers::pi);
    if (std::abs(own.y) > kLeastShare)
        names << sideName(tooth, (own.y > 0.0 ? 0.5 : -0.5) * std::numbers::pi);
    if (std::abs(own.z) > kLeastShare) {
        if (own.z < 0.0)
            names << QCoreApplication::translate("Direction", "apical");
        else
            names << (isKnown && tooth.fdi % 10 <= 3 ? QCoreApplication::translate("Direction", "incisal")
                                                     : QCoreApplication::translate("Direction", "occlusal"));
    }
    //: Two directions at once, such as "mesial / incisal"
    return names.size() < 2 ? names.value(0)
                            : QCoreApplication::translate("Direction", "%1 / %2").arg(names[0], names[1]);
}

QString planeAlongX(const core::terrain::ToothAnatomy& tooth)
{
    return core::teeth::isGenerated(tooth) ? QCoreApplication::translate("Direction", "Mesio-distal")
                                           : QCoreApplication::translate("Direction", "Along x");
}

QString planeAlongY(const core::terrain::ToothAnatomy& tooth)
{
    if (!core::teeth::isGenerated(tooth))
        return QCoreApplication::translate("Direction", "Along y");
    if (tooth.fdi % 10 <= 3)
        return tooth.fdi / 10 == 2 ? QCoreApplication::translate("Direction", "Labio-palatal")
                                   : QCoreApplication::translate("Direction", "Labio-lingual");
    return tooth.fdi / 10 == 2 ? QCoreApplication::translate("Direction", "Bucco-palatal")
                               : QCoreApplication::translate("Direction", "Bucco-lingual");
}

namespace {

/// Returns the name of a carbide bur, with "%1" for its number.
const char* carbideWords(core::bur::BurShape shape)
{
    using Shape = core::bur::BurShape;
    switch (shape) {
    case Shape::Round:
        return QT_TRANSLATE_NOOP("Bur", "Round, No. %1");
    case Shape::InvertedCone:
        return QT_TRANSLATE_NOOP("Bur", "Inverted cone, No. %1");
    case Shape::Straight:
        return QT_TRANSLATE_NOOP("Bur", "Straight fissure, No. %1");
    case Shape::StraightCrosscut:
        return QT_TRANSLATE_NOOP("Bur", "Straight fissure, crosscut, No. %1");
    case Shape::DomedCrosscut:
        return QT_TRANSLATE_NOOP("Bur", "Domed fissure, crosscut, No. %1");
    case Shape::Tapered:
        return QT_TRANSLATE_NOOP("Bur", "Tapered fissure, No. %1");
    case Shape::TaperedCrosscut:
        return QT_TRANSLATE_NOOP("Bur", "Tapered fissure, crosscut, No. %1");
    case Shape::Pear:
        return QT_TRANSLATE_NOOP("Bur", "Pear, No. %1");
    case Shape::LongPear:
        return QT_TRANSLATE_NOOP("Bur", "Long pear, No. %1");
    case Shape::Egg:
        return QT_TRANSLATE_NOOP("Bur", "Egg, No. %1");
    case Shape::Flame:
        return QT_TRANSLATE_NOOP("Bur", "Flame, No. %1");
    case Shape::Cylinder:
        return QT_TRANSLATE_NOOP("Bur", "Cylinder, No. %1");
    case Shape::RoundEndTaper:
        return QT_TRANSLATE_NOOP("Bur", "Round-end taper, No. %1");
    case Shape::Chamfer:
        break;
    }
    return QT_TRANSLATE_NOOP("Bur", "Chamfer, No. %1");
}

/// Returns the name of a diamond bur, with "%1" for its number.
const char* diamondWords(core::bur::BurShape shape)
{
    using Shape = core::bur::BurShape;
    switch (shape) {
    case Shape::Round:
        return QT_TRANSLATE_NOOP("Bur", "Diamond, round, No. %1");
    case Shape::Pear:
    case Shape::LongPear:
        return QT_TRANSLATE_NOOP("Bur", "Diamond, pear, No. %1");
    case Shape::Egg:
        return QT_TRANSLATE_NOOP("Bur", "Diamond, egg, No. %1");
    case Shape::Flame:
        return QT_TRANSLATE_NOOP("Bur", "Diamond, flame, No. %1");
    case Shape::Cylinder:
        return QT_TRANSLATE_NOOP("Bur", "Diamond, cylinder, No. %1");
    case Shape::RoundEndTaper:
        return QT_TRANSLATE_NOOP("Bur", "Diamond, round-end taper, No. %1");
    case Shape::Chamfer:
        return QT_TRANSLATE_NOOP("Bur", "Diamond, chamfer, No. %1");
    default:
        return QT_TRANSLATE_NOOP("Bur", "Diamond, No. %1");
    }
}

}  // namespace

QString burName(std::string_view id)
{
    QString number = QString::fromUtf8(id.data(), static_cast<qsizetype>(id.size()));
    const auto index = core::bur::findBur(id);
    if (!index)
        return number;
    const core::bur::Bur& bur = core::bur::burs()[*index];
    if (bur.isDiamond())
        return QCoreApplication::translate("Bur", diamondWords(bur.shape)).arg(number);
    return QCoreApplication::translate("Bur", carbideWords(bur.shape)).arg(number);
}

QString handpieceName(std::string_view name)
{
    if (name == "turbine")
        return QCoreApplication::translate("Handpiece", "Turbine");
    if (name == "electric")
        //: A red-ring contra-angle: electric motor, geared up
        return QCoreApplication::translate("Handpiece", "Electric");
    if (name == "low-speed")
        return QCoreApplication::translate("Handpiece", "Low-speed");
    return QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
}

QString healthText(std::uint32_t health)
{
    if ((health & core::servo::kDeviceLost) != 0)
        return QCoreApplication::translate("Health", "The handpiece is disconnected: no force. Plug it in again.");
    if ((health & core::servo::kRecordGap) != 0)
        return QCoreApplication::translate("Health", "The computer was too slow: the recording has a gap.");
    if ((health & core::servo::kPatchQueueFull) != 0)
        return QCoreApplication::translate("Health", "The computer is slow: the picture lags behind.");
    if ((health & core::servo::kBegunInside) != 0)
        return QCoreApplication::translate("Health", "The bur is inside the tooth. Lift it out to continue.");
    if ((health & core::servo::kHeldInside) != 0)
        return QCoreApplication::translate("Health", "The outline holds your hand. Press Q to release it.");
    if ((health & core::servo::kLedHome) != 0)
        return QCoreApplication::translate(
            "Health", "The handpiece guides your hand back over the tooth. Push against it to stop.");
    if ((health & core::servo::kLoopIsSlow) != 0)
        return QCoreApplication::translate("Health", "The handpiece responds late: the tooth feels softer.");
    if ((health & core::servo::kForceClamped) != 0)
        return QCoreApplication::translate("Health", "Force at its limit");
    return {};
}

QString criterionName(const lessons::Criterion& criterion)
{
    const std::string& title = lessons::inLanguage(criterion.title, QLocale().name().toStdString());
    return QString::fromStdString(title.empty() ? criterion.measure : title);
}

QString onceWords(const lessons::Once& once)
{
    const QString reaches = QStringLiteral("%1 %2").arg(QLocale().toString(once.reaches, 'g', 4), unitName(once.unit));
    if (once.measure == "caries_removed_percent")
        //: %1: a share: "50 %"
        return QCoreApplication::translate("Criterion", "%1 of the decay is removed").arg(reaches);
    if (once.measure == "ideal_cut_percent")
        return QCoreApplication::translate("Criterion", "%1 of the ideal is cut").arg(reaches);
    if (once.measure == "target_removed_percent")
        return QCoreApplication::translate("Criterion", "%1 of the shape is cut").arg(reaches);
    if (once.measure == "removed_mm3")
        return QCoreApplication::translate("Criterion", "%1 of the tooth is removed").arg(reaches);
    //: %1: the name of a measure, %2: a figure with its unit
    return QCoreApplication::translate("Criterion", "%1 has reached %2")
        .arg(QString::fromStdString(once.measure), reaches.trimmed());
}

QString soundTissueCounted()
{
    return QCoreApplication::translate("Criterion", "Enamel and dentin beside and below the decay. Tissue directly "
                                                    "above the decay must be removed and is not counted.");
}

QString criterionMeasured(const lessons::Criterion& criterion)
{
    if (criterion.measure.empty())
        return {};
    if (!criterion.measured)
        return QCoreApplication::translate("Criterion", "not measured");
    return number(*criterion.measured, criterion.unit == "percent" ? 1 : 2) + u' ' + unitName(criterion.unit);
}

namespace {

/// Returns the calculation of the error beyond the tolerance: "3.20 − 1.00 free" or "
/// 1.95 − 1.50
/// − 0.25 free".
QString errorWorked(const lessons::Criterion& criterion)
{
    const QString value = number(*criterion.measured, 2);
    const QString target = number(criterion.target, 2);
    const QString minus = QStringLiteral(" %1 ").arg(QChar(0x2212));
    QString off = value;
    if (criterion.side == lessons::Side::Both)
        off = QStringLiteral("|%1%2%3|").arg(value, minus, target);
    else if (criterion.side == lessons::Side::Under)
        off = target + minus + value;
    else if (criterion.target != 0.0)
        off = value + minus + target;
    if (criterion.tolerance > 0.0)
        //: %1 is a value, %2 what of it costs nothing: "3.20 − 1.00 free"
        off = QCoreApplication::translate("Criterion", "%1 − %2 free").arg(off, number(criterion.tolerance, 2));
    return off;
}

/// Returns the range that loses no points: "up to 8.00 mm³", "1.50 ± 0.25 mm", "at least 1.60 mm".
QString freeRange(const lessons::Criterion& criterion)
{
    const QString unit = unitName(criterion.unit);
    if (criterion.side == lessons::Side::Both)
        return QStringLiteral("%1 ± %2 %3").arg(number(criterion.target, 2), number(criterion.tolerance, 2), unit);
    if (criterion.side == lessons::Side::Under)
        return QCoreApplication::translate("Criterion", "at least %1 %2")
            .arg(number(criterion.target - criterion.tolerance, 2), unit);
    return QCoreApplication::translate("Criterion", "up to %1 %2")
        .arg(number(criterion.target + criterion.tolerance, 2), unit);
}

}  // namespace

QString criterionWorked(const lessons::Criterion& criterion, lessons::Verdict verdict)
{
    if (criterion.measure.empty())
        return QCoreApplication::translate("Criterion", "The measured value was not saved");
    if (criterion.critical && criterion.isTooEarly)
        //: %1: what has to be done: "50 % of the decay is removed"
        return QCoreApplication::translate("Criterion", "Counts as soon as %1").arg(onceWords(*criterion.once));
    if (criterion.isTooEarly && criterion.lostTenths > 0)
        //: %1: points of a score, %2: what has to be done: "50 % of the decay is removed"
        return QCoreApplication::translate("Criterion", "None of its %1 points are earned before %2")
            .arg(points(verdict == lessons::Verdict::WorstError ? lessons::kFullTenths : criterion.weightTenths),
                 onceWords(*criterion.once));
    if (!criterion.measured && criterion.capTenths > 0)
        //: %1: points of a score
        return QCoreApplication::translate("Criterion", "Not measured, so the score is limited to %1 points")
            .arg(points(criterion.capTenths));
    if (!criterion.measured)
        return criterion.critical
                   ? QCoreApplication::translate(
                         "Criterion", "Not measured, so the attempt fails and the remaining %1 points are lost")
                         .arg(points(criterion.lostTenths))
                   : QCoreApplication::translate("Criterion", "Not measured, so it earns none of its %1 points")
                         .arg(points(criterion.weightTenths));
    if (!(criterion.share > 0.0))
        return QCoreApplication::translate("Criterion", "%1: nothing lost").arg(freeRange(criterion));
    if (criterion.capTenths > 0)
        //: %1 is a range: "up to 0.00 mm²"; %2: points of a score
        return QCoreApplication::translate("Criterion", "Allowed: %1. The score is limited to %2 points")
            .arg(freeRange(criterion), points(criterion.capTenths));
    if (criterion.critical)
        //: %1 is a range: "up to 0.00 mm²"
        return QCoreApplication::translate("Criterion",
                                           "Allowed: %1. The attempt fails and the remaining %2 points are lost")
            .arg(freeRange(criterion), points(criterion.lostTenths));
    const int weight = verdict == lessons::Verdict::WorstError ? lessons::kFullTenths : criterion.weightTenths;
    if (verdict == lessons::Verdict::WorstError && criterion.lostTenths == 0)
        return QCoreApplication::translate("Criterion", "%1 %2 outside the limit; a more serious error decides")
            .arg(number(criterion.error, 2), unitName(criterion.unit));
    if (criterion.span <= 0.0)
        return QCoreApplication::translate("Criterion", "%1; beyond it all of its %2 points are lost")
            .arg(freeRange(criterion), points(weight));
    const QString worked =
        QCoreApplication::translate("Criterion", "(%1) / %2 %3 × %4 points")
            .arg(errorWorked(criterion), number(criterion.span, 2), unitName(criterion.unit), points(weight));
    return criterion.share < 1.0 ? worked + QStringLiteral(" = %1").arg(points(criterion.lostTenths))
                                 : QCoreApplication::translate("Criterion", "%1, at most all of them").arg(worked);
}

QString scoreSum(const lessons::ScoreSheet& sheet)
{
    if (sheet.criteria.empty())  // the criteria that cost points are unknown
        return points(sheet.totalTenths);
    QString sum = points(lessons::kFullTenths);
    for (const lessons::Criterion& criterion : sheet.criteria)
        sum += QStringLiteral(" %1 %2").arg(QChar(0x2212)).arg(points(criterion.lostTenths));
    return QStringLiteral("%1 = %2").arg(sum, points(sheet.totalTenths));
}

QString points(int tenths)
{
    return QLocale().toString(tenths / 10) + QLocale().decimalPoint() + QLocale().toString(tenths % 10);
}

QString unitName(std::string_view unit)
{
    if (unit == "mm3")
        return QStringLiteral("mm³");
    if (unit == "mm2")
        return QStringLiteral("mm²");
    if (unit == "deg")
        return QStringLiteral("°");
    if (unit == "percent")
        return QStringLiteral("%");
    if (unit == "mm/s3")
        return QStringLiteral("mm/s³");
    return QString::fromUtf8(unit.data(), static_cast<qsizetype>(unit.size()));
}

QString number(double value, int decimals)
{
    QString text = QLocale().toString(value, 'f', decimals);
    return text.replace(u'-', QChar(0x2212));
}

QString capitalised(QString words)
{
    if (!words.isEmpty())
        words[0] = words[0].toUpper();
    return words;
}

QString dayFormat(const QString& translated)
{
    const bool isMonthFirst = QLocale().dateFormat(QLocale::ShortFormat).startsWith(u'M');
    return translated == u"d MMM" && isMonthFirst ? QStringLiteral("MMM d") : translated;
}

QString duration(double seconds)
{
    const int whole = static_cast<int>(seconds);
    return QStringLiteral("%1:%2").arg(whole / 60).arg(whole % 60, 2, 10, QLatin1Char('0'));
}

QString aidWords(std::uint64_t aids)
{
    using namespace core::servo;
    QStringList used;
    const auto add = [&](Aid aid, const QString& words) {
        if ((aids & aid) != 0)
            used << words;
    };
    add(kSectionAid, QCoreApplication::translate("TimeLine", "section"));
    add(kDepthGaugeAid, QCoreApplication::translate("TimeLine", "depth gauge"));
    add(kRadiographAid, QCoreApplication::translate("TimeLine", "X-ray"));
    add(kHeatMapAid, QCoreApplication::translate("TimeLine", "depth colours"));
    add(kMirrorAid, QCoreApplication::translate("TimeLine", "mirror"));
    add(kIdealAid, QCoreApplication::translate("TimeLine", "ideal"));
    add(kBurColourAid, QCoreApplication::translate("TimeLine", "colour of the bur"));
    add(kFixtureAid, QCoreApplication::translate("TimeLine", "guided hand"));
    return used.isEmpty()
               ? QCoreApplication::translate("TimeLine", "No aids in use")
               : QCoreApplication::translate("TimeLine", "Aids in use: %1").arg(used.join(QStringLiteral(", ")));
}

}  // namespace ui::text
