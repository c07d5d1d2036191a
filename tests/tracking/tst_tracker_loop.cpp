// SPDX-License-Identifier: GPL-3.0-or-later
// The loop of head tracking with sources that behave like cameras: they show a tag, lose it, are unplugged and return.
#include <QTest>
#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>

#include "core/tracking/TagCells.h"
#include "core/tracking/TrackerLoop.h"

using namespace core::tracking;
using namespace std::chrono_literals;

namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 240;
constexpr int kCellPx = 10;

/// Returns a picture with a tag seen straight on, on a grey that changes with each picture.
Picture pictureOf(int id, unsigned n, int tags = 1)
{
    Picture picture;
    picture.width = kWidth;
    picture.height = kHeight;
    picture.pixels.assign(static_cast<std::size_t>(kWidth) * kHeight, static_cast<std::uint8_t>(120 + n % 5));
    const TagCells cells = cellsOf(id);
    for (int tag = 0; tag < tags; ++tag)
        for (int y = 0; y < kCellsASide * kCellPx; ++y)
            for (int x = 0; x < kCellsASide * kCellPx; ++x) {
                const auto cell = static_cast<std::size_t>(y / kCellPx * kCellsASide + x / kCellPx);
                const int at = (y + 60) * kWidth + x + 30 + tag * 140;
                picture.pixels[static_cast<std::size_t>(at)] = cells.at(cell) ? 230 : 20;
            }
    return picture;
}

/// The behaviour of a test's camera; any thread.
struct Script
{
    std::atomic<bool> isPlugged{true};
    std::atomic<int> tags{1};
    std::atomic<int> pictures{0};
};

class ScriptedCamera final : public PictureSource
{
public:
    explicit ScriptedCamera(Script& script) : m_script(script) {}
    core::Result<bool> next(Picture& picture) override
    {
        std::this_thread::sleep_for(2ms);
        if (!m_script.isPlugged)
            return core::unexpected(core::ErrorCode::ConnectionLost, "The camera is gone.");
        picture = pictureOf(3, static_cast<unsigned>(++m_script.pictures), m_script.tags);
        picture.timeS = std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
        return true;
    }
    bool isLive() const override { return true; }

private:
    Script& m_script;
};

/// A source of three pictures, like a video file.
class ScriptedVideo final : public PictureSource
{
public:
    core::Result<bool> next(Picture& picture) override
    {
        if (m_next == 3)
            return false;
        picture = pictureOf(3, static_cast<unsigned>(m_next));
        picture.timeS = 0.04 * m_next++;
        return true;
    }
    bool isLive() const override { return false; }

private:
    int m_next = 0;
};

TrackerSettings settings()
{
    TrackerSettings wanted;
    wanted.id = 3;
    return wanted;
}

/// Runs a loop in a thread, as app/threads/LoopThread does.
class Runner
{
public:
    explicit Runner(TrackerLoop& loop)
        : m_thread([this, &loop] {
              loop.begin();
              while (!m_isStopping) {
                  loop.tick(1ms);
                  static_cast<void>(loop.waitForBeat(std::chrono::steady_clock::now()));
              }
              loop.end();
          })
    {}
    ~Runner()
    {
        m_isStopping = true;
        m_thread.join();
    }

private:
    std::atomic<bool> m_isStopping{false};
    std::thread m_thread;
};

constexpr int kPatienceMs = 20'000;

}  // namespace

class TestTrackerLoop : public QObject
{
    Q_OBJECT
private slots:
    void init()
    {
        m_script.isPlugged = true;
        m_script.tags = 1;
    }

    void followsATag()
    {
        TrackerLoop loop(camera(), settings());
        Runner runner(loop);
        QTRY_VERIFY_WITH_TIMEOUT(loop.report().stage == TrackerStage::Tracking, kPatienceMs);
        QTRY_VERIFY_WITH_TIMEOUT(loop.head().isSeen, kPatienceMs);
        // An edge of 80 pixels at f = 277 pixels: 50 mm seen at 173 mm.
        QVERIFY(std::abs(loop.head().pose.positionMm.z - 173.2) < 3.0);
        QCOMPARE(loop.report().sameTags, 1);
        QTRY_VERIFY_WITH_TIMEOUT(loop.report().hz > 0.0, kPatienceMs);
        QVERIFY(loop.report().picture.pixels.empty());
        loop.showPictures(true);
        QTRY_COMPARE_WITH_TIMEOUT(loop.report().picture.width, kWidth, kPatienceMs);
    }

    void saysThatTheTagIsNotSeen()
    {
        TrackerLoop loop(camera(), settings());
        Runner runner(loop);
        QTRY_VERIFY_WITH_TIMEOUT(loop.report().stage == TrackerStage::Tracking, kPatienceMs);
        m_script.tags = 0;
        QTRY_VERIFY_WITH_TIMEOUT(loop.report().stage == TrackerStage::NoTag, kPatienceMs);
        QVERIFY(!loop.head().isSeen);
        m_script.tags = 1;
        QTRY_VERIFY_WITH_TIMEOUT(loop.report().stage == TrackerStage::Tracking, kPatienceMs);
    }

    void countsTwoTagsWithTheSameNumber()
    {
        m_script.tags = 2;
        TrackerLoop loop(camera(), settings());
        Runner runner(loop);
        QTRY_COMPARE_WITH_TIMEOUT(loop.report().sameTags, 2, kPatienceMs);
    }

    void aCameraGoesAndComesBack()
    {
        m_script.isPlugged = false;
        TrackerLoop loop(camera(), settings());
        Runner runner(loop);
        QTRY_VERIFY_WITH_TIMEOUT(loop.report().stage == TrackerStage::NoCamera, kPatienceMs);
        QVERIFY(!loop.report().error.detail.empty());
        m_script.isPlugged = true;
        QTRY_VERIFY_WITH_TIMEOUT(loop.report().stage == TrackerStage::Tracking, kPatienceMs);
        QVERIFY(loop.report().error.detail.empty());
        m_script.isPlugged = false;
        QTRY_VERIFY_WITH_TIMEOUT(loop.report().stage == TrackerStage::NoCamera, kPatienceMs);
        m_script.isPlugged = true;
        QTRY_VERIFY_WITH_TIMEOUT(loop.report().stage == TrackerStage::Tracking, kPatienceMs);
    }

    void aVideoEnds()
    {
        TrackerLoop loop([] { return core::Result<std::unique_ptr<PictureSource>>(std::make_unique<ScriptedVideo>()); },
                         settings());
        Runner runner(loop);
        QTRY_VERIFY_WITH_TIMEOUT(loop.report().stage == TrackerStage::Ended, kPatienceMs);
        QVERIFY(loop.head().seenS > 0.0);
    }

    void aCalibrationForOtherPicturesIsRefused()
    {
        TrackerSettings wanted = settings();
        wanted.calibration = CameraModel::withFieldOfView(640, 480, 60.0);
        TrackerLoop loop(camera(), wanted);
        Runner runner(loop);
        QTRY_VERIFY_WITH_TIMEOUT(loop.report().stage == TrackerStage::NoCamera, kPatienceMs);
        QVERIFY(loop.report().error.code == core::ErrorCode::OutOfRange);
    }

private:
    [[nodiscard]] TrackerLoop::Open camera()
    {
        return [this]() -> core::Result<std::unique_ptr<PictureSource>> {
            if (!m_script.isPlugged)
                return core::unexpected(core::ErrorCode::FileMissing, "No camera is plugged in.");
            return std::make_unique<ScriptedCamera>(m_script);
        };
    }

    Script m_script;
};

QTEST_GUILESS_MAIN(TestTrackerLoop)
#include "tst_tracker_loop.moc"
