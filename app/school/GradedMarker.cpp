// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/school/GradedMarker.h"

#include <fstream>
#include <system_error>

namespace app {
namespace {

std::filesystem::path markOf(std::filesystem::path journal)
{
    journal += ".graded";
    return journal;
}

}  // namespace

void markGraded(const std::filesystem::path& journal, const GradedMarker& mark)
{
    std::error_code failure;
    std::filesystem::path part = markOf(journal);
    part += ".part";
    {
        std::ofstream out(part);
        std::filesystem::permissions(part, std::filesystem::perms::owner_read | std::filesystem::perms::owner_write,
                                     failure);
        out << mark.uid << '\n' << mark.events << '\n';
        if (mark.expectedTenths)
            out << *mark.expectedTenths << '\n';
        out.close();
        if (!out) {
            std::filesystem::remove(part, failure);
            return;
        }
    }
    std::filesystem::rename(part, markOf(journal), failure);
}

std::optional<GradedMarker> gradedMark(const std::filesystem::path& journal)
{
    std::ifstream in(markOf(journal));
    GradedMarker mark;
    if (!(in >> mark.uid >> mark.events))
        return std::nullopt;
    if (int expected = 0; in >> expected)
        mark.expectedTenths = expected;
    return mark;
}

void removeGradedMark(const std::filesystem::path& journal)
{
    std::error_code failure;
    std::filesystem::remove(markOf(journal), failure);
}

void tidyGradedMarks(const std::filesystem::path& folder)
{
    std::error_code failure;
    for (std::filesystem::directory_iterator at(folder, failure), end; !failure && at != end; at.increment(failure)) {
        std::filesystem::path journal = at->path();
        if (journal.extension() != ".graded")
            continue;
        journal.replace_extension();
        std::filesystem::path part = journal;
        part += ".part";  // the name of a journal until its first sync to the disk
        std::error_code gone;
        if (!std::filesystem::exists(journal, gone) && !std::filesystem::exists(part, gone))
            removeGradedMark(journal);
    }
}

}  // namespace app
