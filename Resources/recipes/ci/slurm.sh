#!/usr/bin/env bash
# sbatch --array=1-NUMBER_OF_PARTS slurm.sh: each task mills one part of this folder, in the order of their names
# SPDX-License-Identifier: LGPL-2.1-or-later
#SBATCH --cpus-per-task=1 --mem=4G --time=00:20:00
set -euo pipefail
parts=(*.step)
part=${parts[$((SLURM_ARRAY_TASK_ID - 1))]}
patchmill run "$part" --recipe mould.json -o "out/${part%.step}" --resume
