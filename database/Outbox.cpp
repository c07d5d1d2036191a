// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/Outbox.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>
#include <vector>

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include "core/base/Bytes.h"
#include "core/base/WholeFile.h"
#include "database/FileSystem.h"
#include "database/Passwords.h"
#include "database/Permissions.h"

namespace database {
namespace {

using core::ErrorCode;

constexpr std::string_view kMagic = "CUSPOUT2";
constexpr std::size_t kKeyDigits = 64;
constexpr std::size_t kSignatureDigits = 128;
constexpr qint64 kLargest = 1LL << 30U;
const QString kEnding = QStringLiteral(".attempt");
const QString kExamEnding = QStringLiteral(".exam");
const QString kArrived = QStringLiteral("arrived");

/// Returns the texts of a record, in the order of the file.
template <class Record>
auto textsOf(Record& r)
{
    return std::array{&r.uid,        &r.personUid, &r.finishedUtc,    &r.tooth,   &r.lessonId,     &r.lessonHash,
                      &r.rubricHash, &r.stateHash, &r.scoreSheetJson, &r.device,  &r.method,       &r.viewMode,
                      &r.seed,       &r.preset,    &r.presetHash,     &r.program, &r.recordingHash};
}

std::string bytesOf(const AttemptRecord& attempt)
{
    core::ByteWriter bytes;
    for (const std::string* text : textsOf(attempt))
        bytes.putText(*text);
    for (const std::int64_t value :
         {std::int64_t{attempt.scoreTenths}, std::int64_t{attempt.passed ? 1 : 0}, std::int64_t{attempt.passMarkTenths},
          std::int64_t{attempt.expectedTenths.value_or(-1)}, attempt.durationMs, std::int64_t{attempt.grid},
          std::int64_t{attempt.meanForceMn}, std::int64_t{attempt.peakForceMn},
          static_cast<std::int64_t>(attempt.criteria.size())})
        bytes.put(value);
    for (const CriterionLoss& criterion : attempt.criteria) {
        bytes.putText(criterion.id);
        bytes.put(std::int64_t{criterion.lostTenths});
        bytes.put(std::int64_t{criterion.weightTenths});
    }
    return bytes.bytes();
}

bool takeAttempt(core::ByteReader& bytes, AttemptRecord& attempt)
{
    for (std::string* text : textsOf(attempt))
        *text = bytes.takeText();
    const auto number = [&bytes] { return bytes.take<std::int64_t>(); };
    attempt.scoreTenths = static_cast<int>(number());
    attempt.passed = number() != 0;
    attempt.passMarkTenths = static_cast<int>(number());
    if (const auto expected = static_cast<int>(number()); expected >= 0)
        attempt.expectedTenths = expected;
    attempt.durationMs = number();
    attempt.grid = static_cast<int>(number());
    attempt.meanForceMn = static_cast<int>(number());
    attempt.peakForceMn = static_cast<int>(number());
    const std::int64_t criteria = number();
    for (std::int64_t k = 0; k < criteria && bytes.ok(); ++k) {
        CriterionLoss criterion;
        criterion.id = bytes.takeText();
        criterion.lostTenths = static_cast<int>(number());
        criterion.weightTenths = static_cast<int>(number());
        attempt.criteria.push_back(std::move(criterion));
    }
    return bytes.ok();
}

/// Returns whether a text is a moment as this program writes it: "2026-11-20T10:15:00Z".
bool isMoment(const std::string& utc)
{
    const QString text = QString::fromStdString(utc);
    return text.endsWith(u'Z') && QDateTime::fromString(text, QStringLiteral("yyyy-MM-ddTHH:mm:ssZ")).isValid();
}

/// Returns whether a file has the form that this program writes. A database refuses some other forms, so that they
/// would block the files behind them, and changes others, so that its check finds a difference for ever.
bool isFit(const std::string& uid, const std::string& momentUtc, const std::vector<const std::string*>& texts)
{
    return uid.size() == kUidLength && isMoment(momentUtc) &&
           std::all_of(texts.begin(), texts.end(), [](const std::string* text) {
               return core::isUtf8(*text) && text->find('\0') == std::string::npos;
           });
}

bool isFit(AttemptRecord& attempt)
{
    const auto fields = textsOf(attempt);
    std::vector<const std::string*> texts(fields.begin(), fields.end());
    for (const CriterionLoss& criterion : attempt.criteria)
        texts.push_back(&criterion.id);
    return isFit(attempt.uid, attempt.finishedUtc, texts);
}

/// Returns the files in a folder, oldest first.
QStringList lettersIn(const QString& folder)
{
    QStringList files;
    const QDir there(folder);
    for (const QString& name :
         there.entryList({'*' + kExamEnding, '*' + kEnding}, QDir::Files, QDir::Time | QDir::Reversed))
        files += there.filePath(name);
    return files;
}

/// Moves a file to a folder. It replaces a file of the same name, which contains the same attempt.
bool move(const QString& file, const QString& folder)
{
    makeOwnFolder(folder);
    const QString target = QDir(folder).filePath(QFileInfo(file).fileName());
    if (rename(QFile::encodeName(file).constData(), QFile::encodeName(target).constData()) != 0)
        return false;
    core::bringToDisk(folder.toStdU16String());
    return true;
}

core::Error refused(ErrorCode code, const QString& file, const std::string& why)
{
    return {code, "attempt " + file.toStdString() + ": " + why};
}

core::Error damaged(const QString& file)
{
    return refused(ErrorCode::BadStructure, file, "it is damaged; it is kept in the folder \"damaged\"");
}

/// Returns why a file could not be read. First checks whether it still exists, because another program of the same user
/// may have delivered it.
core::Error unreadable(const QString& file)
{
    const QFileInfo now(file);
    if (!now.exists() && !now.isSymLink())
        return refused(ErrorCode::FileMissing, file, "it is gone; another program has delivered it");
    if (now.isSymLink() || !now.isFile() || now.size() > kLargest)
        return damaged(file);
    return refused(ErrorCode::FileUnreadable, file, "it cannot be read; check the disk and who may read it");
}

}  // namespace

core::Status Outbox::put(const Login& session, const AttemptRecord& attempt, const QByteArray& recording)
{
    if (reachOf(Operation::AddAttempt, session.role()) == Reach::Nothing)
        return core::unexpected(ErrorCode::NotAllowed, "a guest's attempts are not kept; log in first");
    AttemptRecord own = attempt;
    own.personUid = session.uid();
    own.recordingHash.clear();
    core::ByteWriter content;
    content.putText(bytesOf(own));
    content.putText({recording.constData(), static_cast<std::size_t>(recording.size())});
    content.putText(m_school.toStdString());
    return write(QString::fromStdString(own.uid) + kEnding, content.bytes());
}

core::Status Outbox::put(const Login& session, const ExamStart& start)
{
    if (reachOf(Operation::AddAttempt, session.role()) == Reach::Nothing)
        return core::unexpected(ErrorCode::NotAllowed, "a guest's exams are not kept; log in first");
    // A resumed exam is reported again. Its first start counts.
    const QString name = QString::fromStdString(start.uid) + kExamEnding;
    if (QFileInfo::exists(QDir(m_folder).filePath(name)))
        return {};
    core::ByteWriter content;
    for (const std::string* text : {&start.uid, &session.uid(), &start.lessonId, &start.begunUtc})
        content.putText(*text);
    content.putText(m_school.toStdString());
    return write(name, content.bytes());
}

core::Status Outbox::write(const QString& name, const std::string& content) const
{
    const std::string signature = m_key.sign(digestOf(content));
    makeOwnFolder(m_folder);
    const QString path = QDir(m_folder).filePath(name);
    const QByteArray bytes = QByteArray::fromStdString(std::string(kMagic) + m_key.publicHex() + signature + content);
    QSaveFile file(path);  // syncs the content before it renames the file
    if (!file.open(QIODevice::WriteOnly) || !file.setPermissions(QFile::ReadOwner | QFile::WriteOwner) ||
        file.write(bytes) != bytes.size() || !file.flush() || !file.commit())
        return tl::unexpected(refused(ErrorCode::FileUnwritable, path,
                                      "it cannot be written (" + file.errorString().toStdString() +
                                          "); make room on the disk, and grade the work again"));
    core::bringToDisk(m_folder.toStdU16String());  // syncs the name of the new file
    return {};
}

QStringList Outbox::waiting() const
{
    return lettersIn(m_folder);
}

bool Outbox::isOfAnother(const QString& file) const
{
    QString school;
    if (isExam(file))
        school = readExam(file).map([](const ExamLetter& letter) { return letter.school; }).value_or(QString());
    else
        school = read(file).map([](const PendingAttempt& letter) { return letter.school; }).value_or(QString());
    // If the other database does not exist, it may be this one under an earlier path.
    return !m_school.isEmpty() && !school.isEmpty() && school != m_school &&
           QFileInfo::exists(QFileInfo(m_folder).dir().filePath(school));
}

QStringList Outbox::arrived() const
{
    QStringList files = lettersIn(QDir(m_folder).filePath(kArrived));
    files.removeIf([this](const QString& file) { return isOfAnother(file); });
    return files;
}

bool Outbox::keepArrived(const QString& file) const
{
    return move(file, QDir(m_folder).filePath(kArrived));
}

void Outbox::sendAgain() const
{
    for (const QString& file : arrived())
        move(file, m_folder);
}

bool Outbox::isExam(const QString& file)
{
    return file.endsWith(kExamEnding);
}

core::Result<std::string> Outbox::contentOf(const QString& path) const
{
    constexpr std::size_t kHead = kMagic.size() + kKeyDigits + kSignatureDigits;
    // Cusp does not create links here, and the target of a link may not belong to Cusp.
    const auto all = QFileInfo(path).isSymLink() ? std::nullopt : database::contentOf(path, kLargest);
    if (!all)
        return tl::unexpected(unreadable(path));
    const std::string_view bytes(all->constData(), static_cast<std::size_t>(all->size()));
    if (bytes.size() < kHead || bytes.substr(0, kMagic.size()) != kMagic)
        return tl::unexpected(damaged(path));
    const std::string key(bytes.substr(kMagic.size(), kKeyDigits));
    const std::string signature(bytes.substr(kMagic.size() + kKeyDigits, kSignatureDigits));
    std::string content(bytes.substr(kHead));
    if (!StationKey::isSigned(digestOf(content), signature, key))
        return tl::unexpected(damaged(path));
    if (key != m_key.publicHex())
        return tl::unexpected(refused(ErrorCode::NotAllowed, path,
                                      "it was signed with another station.key than this station has now; put that one "
                                      "back, and it is sent"));
    return content;
}

core::Result<Outbox::PendingAttempt> Outbox::read(const QString& path) const
{
    const auto content = contentOf(path);
    if (!content)
        return tl::unexpected(content.error());
    PendingAttempt letter;
    core::ByteReader parts(*content);
    const std::string attempt = parts.takeText();
    const std::string recording = parts.takeText();
    core::ByteReader fields(attempt);
    if (!parts.ok() || !takeAttempt(fields, letter.attempt) || !isFit(letter.attempt))
        return tl::unexpected(damaged(path));
    letter.recording = QByteArray::fromStdString(recording);
    letter.school = QString::fromStdString(parts.takeText());  // empty if written by an older program
    return letter;
}

core::Result<Outbox::ExamLetter> Outbox::readExam(const QString& path) const
{
    const auto content = contentOf(path);
    if (!content)
        return tl::unexpected(content.error());
    ExamLetter letter;
    core::ByteReader parts(*content);
    const std::array texts{&letter.start.uid, &letter.personUid, &letter.start.lessonId, &letter.start.begunUtc};
    for (std::string* text : texts)
        *text = parts.takeText();
    if (!parts.ok() || !isFit(letter.start.uid, letter.start.begunUtc, {texts.begin(), texts.end()}))
        return tl::unexpected(damaged(path));
    letter.school = QString::fromStdString(parts.takeText());
    return letter;
}

QString Outbox::schoolAt(const Address& address, const QString& folder)
{
    constexpr int kUsualPort = 5432;
    if (address.isServer())
        return QStringLiteral("postgresql://%1:%2/%3")
            .arg(address.host.toLower())
            .arg(address.port > 0 ? address.port : kUsualPort)
            .arg(address.name);
    const auto canonical = [](const QString& path) { return QFileInfo(path).canonicalFilePath(); };
    const QFileInfo file(address.file);
    return QDir(canonical(folder)).relativeFilePath(QDir(canonical(file.absolutePath())).filePath(file.fileName()));
}

bool Outbox::remove(const QString& file) const
{
    return QFile::remove(file);
}

void Outbox::setAside(const QString& file) const
{
    move(file, QDir(m_folder).filePath(QStringLiteral("damaged")));
}

}  // namespace database
