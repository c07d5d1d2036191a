// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/Usernames.h"

#include <algorithm>

#include <QList>
#include <QString>

namespace database {
namespace {

constexpr int kLongest = 64;

/// Whether joiners change how a letter is written: those of Arabic and Indic scripts, not those of a, α or я.
bool mayBeJoined(uint letter)
{
    switch (QChar::script(letter)) {
    case QChar::Script_Unknown:
    case QChar::Script_Inherited:
    case QChar::Script_Common:
    case QChar::Script_Latin:
    case QChar::Script_Greek:
    case QChar::Script_Cyrillic:
    case QChar::Script_Han:
    case QChar::Script_Hiragana:
    case QChar::Script_Katakana:
        return false;
    default:
        return true;
    }
}

/// Whether a word has letters of several scripts that look alike: an "а" of Cyrillic beside "dmin". Those of China,
/// Japan and Korea look like no others, and are written beside them.
bool mixesScripts(const QList<uint>& letters)
{
    QChar::Script script = QChar::Script_Unknown;  // no letter has told yet
    for (const uint letter : letters) {
        if (!QChar::isLetter(letter)) {
            if (!QChar::isMark(letter) && !QChar::isNumber(letter))
                script = QChar::Script_Unknown;  // a word ends
            continue;
        }
        switch (const QChar::Script here = QChar::script(letter); here) {
        case QChar::Script_Unknown:
        case QChar::Script_Inherited:
        case QChar::Script_Common:
        case QChar::Script_Han:
        case QChar::Script_Hiragana:
        case QChar::Script_Katakana:
        case QChar::Script_Bopomofo:
        case QChar::Script_Hangul:
            break;
        default:
            if (script != QChar::Script_Unknown && script != here)
                return true;
            script = here;
        }
    }
    return false;
}

const char* const kOthers = "a user's name has letters, digits and . _ - @ only; correct it";

/// Letters that are blank: the fillers of Hangul, and the blank pattern of Braille.
bool isBlank(uint letter)
{
    return letter == 0x115F || letter == 0x1160 || letter == 0x3164 || letter == 0xFFA0 || letter == 0x2800;
}

/// Marks that change nothing on most letters: the grapheme joiner, vowels of Khmer that are not written, selectors.
bool isBlankMark(uint mark)
{
    return mark == 0x034F || mark == 0x17B4 || mark == 0x17B5 || (mark >= 0x180B && mark <= 0x180F) ||
           (mark >= 0xFE00 && mark <= 0xFE0F) || (mark >= 0xE0100 && mark <= 0xE01EF);
}

/// A mark stands on a letter; alone it is nothing, or a speck.
bool isMarkAlone(const QList<uint>& letters, qsizetype at)
{
    return QChar::isMark(letters[at]) && (at == 0 || QChar::isSpace(letters[at - 1]));
}

}  // namespace

core::Result<std::string> normalUsername(const std::string& typed)
{
    const QString name =
        QString::fromStdString(typed).normalized(QString::NormalizationForm_KC).trimmed().toCaseFolded();
    const QList<uint> letters = name.toUcs4();
    const auto isFit = [](uint c) {
        return QChar::isLetterOrNumber(c) || QChar::isMark(c) || c == '.' || c == '_' || c == '-' || c == '@';
    };
    if (name.isEmpty())
        return core::unexpected(core::ErrorCode::OutOfRange, "the user's name is empty; give one");
    if (letters.size() > kLongest)
        return core::unexpected(core::ErrorCode::OutOfRange, "the user's name is longer than " +
                                                                 std::to_string(kLongest) + " characters; shorten it");
    if (!std::all_of(letters.begin(), letters.end(), isFit))
        return core::unexpected(core::ErrorCode::OutOfRange, kOthers);
    return name.toStdString();
}

core::Result<std::string> newUsername(const std::string& typed)
{
    auto name = normalUsername(typed);
    if (!name)
        return name;
    const QList<uint> letters = QString::fromStdString(*name).toUcs4();
    const auto isUnseen = [](uint c) { return isBlank(c) || isBlankMark(c); };
    if (std::any_of(letters.begin(), letters.end(), isUnseen) || isMarkAlone(letters, 0))
        return core::unexpected(core::ErrorCode::OutOfRange, kOthers);
    if (mixesScripts(letters))
        return core::unexpected(
            core::ErrorCode::OutOfRange,
            "a word of the user's name has letters of several scripts, which look alike; type it in "
            "one");
    return name;
}

bool canBeSeen(const std::string& name)
{
    const QList<uint> letters = QString::fromStdString(name).toUcs4();
    for (qsizetype i = 0; i < letters.size(); ++i) {
        if (isBlank(letters[i]) || isMarkAlone(letters, i))
            return false;
        if (QChar::isPrint(letters[i]))
            continue;
        const bool isJoiner = letters[i] == 0x200C || letters[i] == 0x200D;
        if (!isJoiner || i == 0 || i + 1 == letters.size() || !mayBeJoined(letters[i - 1]) ||
            !mayBeJoined(letters[i + 1]))
            return false;
    }
    return true;
}

}  // namespace database
