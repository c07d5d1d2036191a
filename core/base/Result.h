// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>

#include <tl/expected.hpp>

#include "core/base/LocalizableText.h"

namespace core {

/// The kind of an error, for code that handles cases differently and for the ui, which has the translated sentences.
enum class ErrorCode {
    FileMissing,     ///< there is no such file
    FileUnreadable,  ///< it exists, but is a directory or may not be read
    FileUnwritable,  ///< it could not be created or written
    FileEmpty,       ///< zero bytes
    FileTruncated,   ///< it ends before what its header declares
    FileTooLarge,    ///< larger than the program accepts
    WrongKind,       ///< readable, but of another format than expected
    NewerVersion,    ///< written by a later program
    OlderVersion,    ///< written by an earlier program, and not to be changed without the user's consent
    BadNumber,       ///< not a number, or not finite
    BadStructure,    ///< the right format with impossible contents
    NoTriangles,     ///< a mesh without a usable face
    UnknownName,     ///< a bur, method, tooth or preset that does not exist
    OutOfRange,      ///< a value outside its range
    OtherTooth,      ///< valid, but made on another tooth than the current one
    Busy,            ///< another program holds it; a retry may succeed
    OpenElsewhere,   ///< only one program at a time can use it
    ConnectionLost,  ///< the server does not respond
    OutcomeUnknown,  ///< the connection was lost during a commit: it may have been made or not
    ServerRefuses,   ///< the server responds with a refusal that its administrator must resolve
    ServerUnknown,   ///< the server could not prove that it is the right one, or cannot encrypt the connection
    OtherSchool,     ///< the database is not that of the school used before
    NotAllowed,      ///< the role of the user does not allow it
    Disabled,        ///< the account was disabled after the login
    WrongLogin,      ///< wrong name or password; the error does not say which
    TooSoon,         ///< after failed logins; the detail gives the waiting time
    NewPassword,     ///< a one-time code was entered: a new password is needed
    NobodyLeft,      ///< the last person with a necessary role would lose it
    ChangedSince,    ///< another user has changed the data since they were read
};

struct Error
{
    ErrorCode code = ErrorCode::WrongKind;
    std::string detail;       ///< one English sentence: what, where, what to do; for the log and the command line
    LocalizableText words{};  ///< the same for translation; empty: not translatable
};

/// An expected failure as a value; our own mistakes are assertions. C++23's std::expected has the same member names.
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

/// Returns an error for translation. A text that exists in English only becomes the value "%1".
[[nodiscard]] inline LocalizableText wordsOf(const Error& error)
{
    return error.words.english.empty() ? LocalizableText{"%1", {noted(error.detail)}} : error.words;
}

}  // namespace core
