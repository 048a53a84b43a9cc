# Sourced by bin/demo, bin/test and bin/Dockerfile: installs what a Debian 12 machine lacks, then
# configures and builds.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

build_packages=(g++ cmake ninja-build libboost-dev libceres-dev libeigen3-dev libgflags-dev
  libgoogle-glog-dev libpugixml-dev nlohmann-json3-dev libssl-dev)
test_packages=("${build_packages[@]}" libgtest-dev libgmock-dev librapidcheck-dev libbenchmark-dev
  chromium clang-format clang-tidy munge python3 python3-jsonschema slurm-client slurmctld slurmd)

# Wherever they come from: live charts of reports are built with npm, and tested with node.
command -v node >/dev/null || test_packages+=(nodejs)
command -v npm >/dev/null || test_packages+=(npm)

# quietly MESSAGE COMMAND...: says the message; shows the command's output only if it fails.
quietly() {
  local message=$1 log status=0
  shift
  echo "$message"
  log=$(mktemp)
  "$@" >"$log" 2>&1 </dev/null || status=$?
  [ "$status" -eq 0 ] || { cat "$log" >&2; echo "failed with exit $status: $*" >&2; }
  rm -f "$log"
  return "$status"
}

missing_packages() {
  local package
  for package in "$@"; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] ||
      echo "$package"
  done
}

# may_sudo: without a terminal nobody can type a password.
may_sudo() {
  command -v sudo >/dev/null && { [ -t 0 ] || sudo -n true 2>/dev/null; }
}

install_missing() {
  command -v dpkg-query >/dev/null || { echo "No Debian packages here; needed: $*"; return 0; }
  local missing as_root=()
  mapfile -t missing < <(missing_packages "$@")
  [ "${#missing[@]}" -gt 0 ] || return 0
  if [ "$(id -u)" -ne 0 ]; then
    may_sudo || { echo "Please install, as root: apt-get install ${missing[*]}" >&2; return 1; }
    as_root=(sudo)
  fi
  as_root+=(env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=600)
  quietly "Updating the package lists" "${as_root[@]}" update &&
    quietly "Installing ${missing[*]}" "${as_root[@]}" install -y --no-install-recommends \
      "${missing[@]}"
}

# configure FOLDER OPTIONS...: keeps the generator of a build folder that exists.
configure() {
  local folder=$1 generator=()
  shift
  [ -e "$folder/CMakeCache.txt" ] || ! command -v ninja >/dev/null || generator=(-G Ninja)
  quietly "Configuring $folder" cmake -S "$root" -B "$folder" "${generator[@]}" "$@"
}

# build FOLDER TARGET...: on a terminal with the builder's own progress line.
build() {
  local folder=$1 quiet=(-- --quiet)
  shift
  [ -t 1 ] && quiet=()
  echo "Building $folder with $(nproc) jobs"
  cmake --build "$folder" --parallel "$(nproc)" --target "$@" "${quiet[@]}" </dev/null
}

# library_packages PROGRAM: the Debian packages that hold the shared libraries it loads; those that
# alternatives choose belong to none and come along as dependencies.
library_packages() {
  local library
  ldd "$1" | awk '$2 == "=>" { print $3 }' | while read -r library; do
    dpkg-query -S "*$library" 2>/dev/null || true
  done | cut -d: -f1 | sort -u
}
