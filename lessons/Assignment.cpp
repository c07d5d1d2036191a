// SPDX-License-Identifier: GPL-3.0-or-later
#include "lessons/Assignment.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>

#include "core/bur/Bur.h"
#include "core/grading/Columns.h"
#include "core/preparation/BlockPreparation.h"
#include "core/preparation/CapturedIdeal.h"
#include "core/preparation/ToothPreparation.h"
#include "core/teeth/Beside.h"
#include "lessons/LessonReader.h"
#include "lessons/RubricReader.h"

namespace lessons {
namespace {

const QString kFreeRubric = QStringLiteral("decay_removal");

core::teeth::BuildOptions buildOptions(const Lesson& lesson)
{
    core::teeth::BuildOptions options;
    options.gridSide = lesson.gridSide;
    if (lesson.lesion) {
        options.cariesExtent = lesson.lesion->extent;
        options.site = lesson.lesion->site;
        options.hasDecayZones = lesson.kind.decay == core::settings::DecayKind::Graded;
    } else {
        options.caries.reset();
    }
    return options;
}

core::Result<core::teeth::BuiltTooth> build(const Lesson& lesson, std::uint64_t drawn)
{
    core::teeth::BuildOptions options = buildOptions(lesson);
    if (const auto* made = std::get_if<MadeTooth>(&lesson.tooth)) {
        options.seed = made->seed;
        options.lying = made->lying;
        return core::teeth::buildTooth({made->fdi}, options);
    }
    if (const auto* block = std::get_if<Block>(&lesson.tooth)) {
        const auto design = designOf(*block);
        if (!design)
            return tl::unexpected(design.error());
        options.seed = block->seed.value_or(drawn);
        return core::teeth::buildTooth({*design}, options);
    }
    const auto& scan = std::get<Scan>(lesson.tooth);
    if (!scan.unit.empty())
        if (const auto unit = core::mesh::parseUnit(scan.unit))
            options.placement.unit = *unit;
    if (!scan.up.empty())
        if (const auto up = core::mesh::parseUp(scan.up))
            options.placement.up = *up;
    options.fdi = scan.fdi;
    options.lying = scan.lying;
    auto built = core::teeth::buildTooth({std::filesystem::path(scan.file)}, options);
    if (!built)
        return core::unexpected(
            built.error().code,
            core::LocalizableText{"%1: %2", {core::noted("tooth.scan"), core::wordsOf(built.error())}});
    return built;
}

/// Returns whether the tooth covers a position (x, y).
bool standsAt(const core::terrain::ToothAnatomy& anatomy, glm::dvec2 placeMm)
{
    const glm::dvec2 at = anatomy.grid.latticeOf(placeMm);
    const auto i = static_cast<int>(std::lround(at.x));
    const auto j = static_cast<int>(std::lround(at.y));
    return anatomy.grid.contains(i, j) && core::grading::wasSolid(anatomy, anatomy.grid.index(i, j));
}

core::Result<core::grading::Preparation> capturedOf(const Captured& captured,
                                                    const core::terrain::ToothAnatomy& anatomy)
{
    const auto ideal = core::preparation::capturedFrom(captured.bytes);
    auto preparation = ideal ? core::preparation::preparationOf(*ideal, anatomy)
                             : core::Result<core::grading::Preparation>(tl::unexpected(ideal.error()));
    if (!preparation)
        return core::unexpected(
            preparation.error().code,
            core::LocalizableText{"%1: %2: %3",
                                  {core::noted("ideal.captured"),
                                   core::noted(std::filesystem::path(captured.file).filename().string()),
                                   core::wordsOf(preparation.error())}});
    return preparation;
}

/// Returns the captured ideal, or otherwise the preparation of its kind for this tooth with the sizes of the lesson.
core::Result<core::grading::Preparation> idealOf(const Ideal& ideal, const core::terrain::ToothAnatomy& anatomy)
{
    if (ideal.captured)
        return capturedOf(*ideal.captured, anatomy);
    const auto kind = core::preparation::findKind(ideal.kind);
    if (!kind)
        return tl::unexpected(kind.error());
    auto design = core::preparation::fittedDesign(*kind, anatomy);
    if (!design)
        return tl::unexpected(design.error());
    const auto fields = core::preparation::fieldsOf(*kind);
    for (const auto& [id, value] : ideal.sizes)
        if (auto set = core::setNumber(std::span(fields), *design, id, value); !set)
            return tl::unexpected(set.error());
    return core::preparation::makePreparation(*kind, *design, anatomy);
}

/// Returns the depth of the flat occlusal floor of a Class I or II below the groove, or the depth of an occlusal
/// reduction. Empty if the lesson has another task.
std::optional<double> occlusalDepthMm(const Assignment& assignment)
{
    if (!assignment.lesson || !assignment.lesson->ideal || assignment.lesson->ideal->captured)
        return {};
    const Ideal& ideal = *assignment.lesson->ideal;
    const auto kind = core::preparation::findKind(ideal.kind);
    if (!kind || !core::preparation::hasOcclusalPart(*kind) || ideal.sizes.contains("follows_junction"))
        return {};
    const bool isReduction = *kind == core::preparation::Kind::OcclusalReduction;
    if (const auto named = ideal.sizes.find(isReduction ? "reduction_mm" : "depth_mm"); named != ideal.sizes.end())
        return named->second;
    const auto usual = core::preparation::usualDesign(*kind, assignment.anatomy->fdi);
    if (!usual)
        return {};
    return isReduction ? usual->reductionMm : usual->depthMm;
}

/// Returns the exercise of a lesson without cutting. The error names the key.
core::Result<core::grading::Exercise> exerciseOf(const Lesson& lesson, const core::terrain::ToothAnatomy& anatomy)
{
    if (lesson.task == Task::HoldForce)
        return *lesson.hold;
    if (lesson.task == Task::TellLayers)
        return core::grading::PadsToName{core::teeth::padMaterials(anatomy.seed)};
    for (std::size_t k = 0; k < lesson.touch->pointsMm.size(); ++k)
        if (const glm::dvec2 place = lesson.touch->pointsMm[k]; !standsAt(anatomy, place))
            return core::unexpected(
                core::ErrorCode::OutOfRange,
                core::LocalizableText{QT_TRANSLATE_NOOP("Fault", "touch.points[%1]: there is no tooth at x = "
                                                                 "%2, y = %3 mm"),
                                      {core::noted(std::to_string(k)), core::noted(core::plainNumber(place.x)),
                                       core::noted(core::plainNumber(place.y))}});
    return *lesson.touch;
}

/// Builds the assignment of a lesson on an existing tooth.
core::Result<Assignment> workOut(const Lesson& lesson, std::shared_ptr<const core::terrain::ToothAnatomy> anatomy)
{
    Assignment assignment;
    assignment.anatomy = std::move(anatomy);
    assignment.rubric = lesson.rubric;
    assignment.lesson = lesson;
    if (lesson.leeway)
        assignment.leeway = core::grading::Leeway{lesson.leeway->sidesMm, lesson.leeway->bottomMm};
    if (const auto* ours = std::get_if<MadeTooth>(&lesson.tooth); ours != nullptr && lesson.rules.neighbourHit)
        assignment.neighbours = core::teeth::teethBeside(ours->fdi);
    if (isExercise(lesson.task)) {
        auto exercise = exerciseOf(lesson, *assignment.anatomy);
        if (!exercise)
            return tl::unexpected(exercise.error());
        assignment.exercise = std::move(*exercise);
    }
    if (lesson.task == Task::CutIdeal) {
        auto ideal = idealOf(*lesson.ideal, *assignment.anatomy);
        if (!ideal)
            return tl::unexpected(ideal.error());
        assignment.ideal = std::move(*ideal);
    }
    if (lesson.task == Task::TraceShape) {
        const auto design = designOf(std::get<Block>(lesson.tooth));
        if (!design)
            return tl::unexpected(design.error());
        auto ideal = core::preparation::blockPreparation(*design, *assignment.anatomy);
        if (!ideal)
            return tl::unexpected(ideal.error());
        assignment.ideal = std::move(*ideal);
    }
    return assignment;
}

/// Returns the area of opened pulp that costs no points, mm2. The rule of a lesson and its score then agree.
double pulpLimitOf(const Rubric& rubric)
{
    for (const CriterionRule& rule : rubric.criteria)
        if (rule.measure == "pulp_exposed_mm2" && rule.side == Side::Over)
            return rule.target + rule.tolerance;
    return core::grading::kPulpLimitMm2;
}

}  // namespace

core::Result<core::teeth::BlockDesign> designOf(const Block& block)
{
    // findBlock() returns a block or an error for such a name, but never no block.
    auto found = core::teeth::findBlock("block:" + block.shape).value();
    if (!found)
        return tl::unexpected(found.error());
    core::teeth::BlockDesign design = *found;
    for (const auto& [id, value] : block.sizes)
        if (auto set = core::setNumber(core::teeth::blockFields(), design, id, value); !set)
            return tl::unexpected(set.error());
    if (auto sound = core::teeth::validate(design); !sound)
        return tl::unexpected(sound.error());
    return design;
}

core::grading::IdealTop Assignment::shownIdeal() const
{
    if (exercise)
        return nullptr;
    return ideal ? ideal->top : core::grading::idealCavity(*anatomy);
}

core::Result<Assigned> assign(const Lesson& lesson, std::uint64_t drawn)
{
    auto built = build(lesson, drawn);
    if (!built)
        return tl::unexpected(built.error());
    auto assignment = workOut(lesson, built->anatomy);
    if (!assignment)
        return tl::unexpected(assignment.error());
    return Assigned{std::move(*assignment), std::move(built->report)};
}

bool isToothOf(const Lesson& lesson, const core::terrain::ToothAnatomy& tooth)
{
    const auto assigned = assign(lesson, tooth.seed);
    return assigned && core::terrain::isAlmostSameTooth(*assigned->assignment.anatomy, tooth);
}

bool isSameLesson(const Assignment& a, const Assignment& b)
{
    return a.lesson && b.lesson && a.lesson->id == b.lesson->id && a.lesson->exam == b.lesson->exam;
}

double depthToCutMm(const Assignment& assignment)
{
    constexpr double kUsualMm = 1.5;
    const core::grading::IdealTop ideal = assignment.anatomy ? assignment.shownIdeal() : nullptr;
    if (ideal == nullptr)
        return kUsualMm;
    if (const auto depth = occlusalDepthMm(assignment))
        return *depth;
    const auto isFloor = [&](std::size_t k) {
        return assignment.ideal && assignment.ideal->parts[k] == core::grading::Part::Floor;
    };
    std::vector<double> depths;
    for (std::size_t k = 0; k < ideal->size(); ++k)
        if (assignment.anatomy->top[k] > assignment.anatomy->bottom[k] && (*ideal)[k] < assignment.anatomy->top[k] &&
            (!assignment.ideal || isFloor(k)))
            depths.push_back(static_cast<double>(assignment.anatomy->top[k]) -
                             static_cast<double>(std::max((*ideal)[k], assignment.anatomy->bottom[k])));
    if (depths.empty())
        return kUsualMm;
    const double deepest = *std::max_element(depths.begin(), depths.end());
    std::erase_if(depths, [&](double depth) { return depth < 0.5 * deepest; });
    const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
    std::nth_element(depths.begin(), middle, depths.end());
    return *middle;
}

bool beginsWithOutline(const Assignment& assignment)
{
    const std::optional<Lesson>& lesson = assignment.lesson;
    return lesson && lesson->task != Task::RemoveDecay && lesson->aids.ideal && !lesson->exam &&
           assignment.shownIdeal() != nullptr;
}

core::Result<Rubric> practiceRubric()
{
    return shippedRubric(kFreeRubric);
}

core::Result<Assignment> practiceOn(std::shared_ptr<const core::terrain::ToothAnatomy> anatomy)
{
    auto rubric = practiceRubric();
    if (!rubric)
        return tl::unexpected(rubric.error());
    Assignment assignment;
    assignment.anatomy = std::move(anatomy);
    assignment.rubric = std::move(*rubric);
    return assignment;
}

core::Result<Assignment> assignmentOf(std::shared_ptr<const core::terrain::ToothAnatomy> anatomy,
                                      const std::string& lessonJson)
{
    if (lessonJson.empty())
        return practiceOn(std::move(anatomy));
    ReadLesson read = readLessonText(QByteArray::fromStdString(lessonJson), QStringLiteral("the recording's lesson"));
    if (!read.lesson)
        return core::unexpected(core::ErrorCode::BadStructure, read.faults.front().sentence().toStdString());
    return workOut(*read.lesson, std::move(anatomy));
}

core::Result<core::recording::Recording> readExpert(const Assignment& assignment)
{
    if (!assignment.lesson || !assignment.lesson->expert)
        return core::unexpected(core::ErrorCode::FileMissing, "the lesson names no expert's recording");
    const std::filesystem::path path(assignment.lesson->expert->file);
    const std::string where = path.filename().string() + ": ";
    if (!path.is_absolute())
        return core::unexpected(core::ErrorCode::FileMissing,
                                where + "this attempt was taken up again, and only the lesson's own folder has the "
                                        "file; open the lesson anew to see it");
    auto recording = core::recording::readRecording(path);
    if (!recording)
        return recording;
    const core::terrain::ToothAnatomy& experts = *recording->anatomy();
    const core::terrain::ToothAnatomy& ours = *assignment.anatomy;
    const bool mayDiffer = assignment.lesson->task == Task::TellLayers;
    if (!core::terrain::isSameTooth(experts, ours) &&
        !(mayDiffer && core::preparation::surfaceHash(experts) == core::preparation::surfaceHash(ours))) {
        const auto words = [](const core::terrain::ToothAnatomy& tooth) {
            return "'" + tooth.name + "' (seed " + std::to_string(tooth.seed) + ", grid " +
                   std::to_string(tooth.grid.side) + ")";
        };
        return core::unexpected(core::ErrorCode::OtherTooth,
                                where + "the attempt is at the tooth " + words(experts) + ", the lesson's is " +
                                    words(ours) +
                                    ", or its decay is another; record an attempt at this lesson and name that");
    }
    return recording;
}

core::servo::ServoSettings servoSettings(const Lesson* lesson, core::servo::ServoSettings usual,
                                         const core::settings::FeelPreset& preset,
                                         const core::settings::ToothKind& kind)
{
    core::settings::putForces(preset, usual.force);
    usual.hardness = core::settings::hardnessFor(preset, lesson != nullptr ? lesson->kind : kind);
    if (lesson != nullptr) {
        if (lesson->hardness)
            usual.hardness = *lesson->hardness;
        usual.breakOff.on = lesson->breakOff;
    }
    if (lesson != nullptr && !lesson->handpieces.empty()) {
        usual.handpieces = lesson->handpieces;
    } else {
        const auto all = core::settings::handpieces();
        usual.handpieces.assign(all.begin(), all.end());
    }
    return usual;
}

core::session::Examination examinationOf(const Assignment& assignment)
{
    core::session::Examination examination;
    examination.ideal = assignment.shownIdeal();
    examination.exercise = assignment.exercise;
    if (!assignment.lesson)
        return examination;
    const Rules& rules = assignment.lesson->rules;
    core::grading::Rules& watched = examination.rules;
    if (rules.pulpExposed)
        watched.pulpLimitMm2 = pulpLimitOf(assignment.lesson->rubric);
    watched.perforated = rules.perforated;
    watched.neighbours = assignment.neighbours;
    watched.depthLimitMm = rules.depthLimitMm;
    watched.ridgeLimitMm = rules.ridgeLimitMm;
    watched.besideLimitMm = rules.besideMm;
    watched.forceLimitN = rules.forceLimitN;
    watched.airLimitS = rules.airLimitS;
    if (!assignment.lesson->burs.empty())
        watched.allowedBurs.reset();
    for (const std::string& bur : assignment.lesson->burs)
        if (const auto index = core::bur::findBur(bur))
            watched.allowedBurs.set(*index);
    return examination;
}

core::Result<Remarked>
markAgain(const core::recording::Recording& recording,
          const std::function<void(const core::servo::ServoEvent&, const core::recording::Replayer&)>& afterEvent)
{
    const auto assignment = assignmentOf(recording.anatomy(), recording.lesson());
    if (!assignment)
        return tl::unexpected(assignment.error());
    core::session::LiveAssessor examiner(examinationOf(*assignment), recording.anatomy());
    auto outcome = core::recording::replay(
        recording, [&](const core::servo::ServoEvent& event, const core::recording::Replayer& servo) {
            examiner.take(event, servo);
            if (afterEvent)
                afterEvent(event, servo);
        });
    if (!outcome)
        return tl::unexpected(outcome.error());
    Conduct conduct{examiner.process(), examiner.infractions(), examiner.aids(), examiner.practised()};
    auto marked = mark(*assignment, outcome->tooth, conduct);
    if (!marked)
        return tl::unexpected(marked.error());
    return Remarked{std::move(*outcome), std::move(*marked), std::move(conduct)};
}

void Conduct::addTo(core::grading::Measured& measured) const
{
    const auto isHit = [](const core::grading::Infraction& infraction) {
        return infraction.breach == core::grading::RuleViolation::NeighbourHit;
    };
    measured.process = process;
    measured.infractions = static_cast<int>(infractions.size());
    measured.neighbourHits = static_cast<int>(std::count_if(infractions.begin(), infractions.end(), isHit));
    measured.aidsUsed = std::popcount(aids);
    measured.practised = practised;
}

core::Result<Mark> mark(const Assignment& assignment, const core::terrain::Tooth& tooth,
                        const std::optional<Conduct>& conduct)
{
    Mark result;
    result.measured.measures = core::grading::measure(tooth, assignment.shownIdeal());
    if (!assignment.ideal && !assignment.exercise)
        result.measured.lesion = core::grading::measureLesionCut(tooth);
    if (conduct)
        conduct->addTo(result.measured);
    if (assignment.ideal) {
        auto deviation = core::grading::measureDeviation(tooth, *assignment.ideal, assignment.leeway);
        if (!deviation)
            return tl::unexpected(deviation.error());
        result.measured.deviation = *deviation;
    }
    result.sheet = grade(assignment.rubric, valuesOf(result.measured));
    return result;
}

}  // namespace lessons
