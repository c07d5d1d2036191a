// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>

#include <tl/expected.hpp>

#include "core/base/LocalizableText.h"

namespace core {

/// What went wrong, for code that must tell cases apart and for the ui, which owns the translated sentences.
enum class ErrorCode {
    FileMissing,     ///< nothing there
    FileUnreadable,  ///< there, but a directory, or not ours to read
    FileUnwritable,  ///< could not be created or filled
    FileEmpty,       ///< zero bytes
    FileTruncated,   ///< ends before what its own header promises
    FileTooLarge,    ///< more than the program is willing to hold
    WrongKind,       ///< readable, but not the format it is named for
    NewerVersion,    ///< written by a later program
    OlderVersion,    ///< written by an earlier program, and not to be changed without being asked
    BadNumber,       ///< not a number, or not a finite one
    BadStructure,    ///< right format, impossible content
    NoTriangles,     ///< a mesh without one usable face
    UnknownName,     ///< a bur, method, tooth or preset that does not exist
    OutOfRange,      ///< a value outside what is allowed
    OtherTooth,      ///< sound, but made on another tooth than the one at hand
    Busy,            ///< another program holds it; the same may work in a moment
    OpenElsewhere,   ///< what one program at a time can use, until the other ends
    ConnectionLost,  ///< a server that does not answer, or not any more
    OutcomeUnknown,  ///< a server that went away while it was confirming: it may be done or not
    ServerRefuses,   ///< a server that answers, and says no: whoever looks after it decides
    OtherSchool,     ///< another school is where the one was that was worked in
    NotAllowed,      ///< by the role of who asked
    Disabled,        ///< the account of who asked, since he logged in
    WrongLogin,      ///< name or password, and nobody is told which
    TooSoon,         ///< after failed logins; the detail says how long to wait
    NewPassword,     ///< a one-time code was given: a password has to be chosen
    NobodyLeft,      ///< he is the last who can do what somebody must be able to do
    ChangedSince,    ///< somebody else has changed what was to be changed, after it was looked at
};

struct Error
{
    ErrorCode code = ErrorCode::WrongKind;
    std::string detail;       ///< one English sentence: what, where, what to do; for the log and the command line
    LocalizableText words{};  ///< the same for a window, where it can say it in its language; else empty
};

/// Expected failure as a value, as opposed to a mistake of ours, which is an assertion. C++23's std::expected has the
/// same member names.
template <class T>
using Result = tl::expected<T, Error>;
using Status = Result<void>;

[[nodiscard]] inline tl::unexpected<Error> unexpected(ErrorCode code, std::string detail)
{
    return tl::unexpected<Error>(Error{code, std::move(detail)});
}

[[nodiscard]] inline tl::unexpected<Error> unexpected(ErrorCode code, LocalizableText words)
{
    std::string detail = inEnglish(words);
    return tl::unexpected<Error>(Error{code, std::move(detail), std::move(words)});
}

/// What is said of an error. A window puts a word of its own round what it can say in English only: "%1".
[[nodiscard]] inline LocalizableText wordsOf(const Error& error)
{
    return error.words.english.empty() ? LocalizableText{"%1", {noted(error.detail)}} : error.words;
}

}  // namespace core
