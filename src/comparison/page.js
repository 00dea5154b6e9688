'use strict';
const frames = document.querySelector('.frames');
const pairs = {ea: ['expected', 'actual'], ed: ['expected', 'difference'], ad: ['actual', 'difference']};

function show(mode) {
  frames.classList.toggle('slide', mode in pairs);
  frames.classList.toggle('side', !(mode in pairs));
  const [base, top] = pairs[mode] ?? [];
  for (const picture of frames.querySelectorAll('.stage:not(.single) figure')) {
    picture.classList.toggle('base', picture.classList.contains(base));
    picture.classList.toggle('top', picture.classList.contains(top));
  }
}

function settle() {
  const chosen = (name) => document.querySelector(`input[name=${name}]:checked`).value;
  show(chosen('mode'));
  frames.dataset.zoom = chosen('zoom');
  frames.classList.toggle('marked', document.getElementById('mark').checked);
}

/** Goes to the next frame below what is shown, or to the one before. */
function step(by) {
  const all = [...document.querySelectorAll('article')];
  const top = document.querySelector('.bar').getBoundingClientRect().bottom + 20;
  const current = all.findLastIndex((article) => article.getBoundingClientRect().top <= top);
  const next = all[Math.min(Math.max(current + by, 0), all.length - 1)];
  next.scrollIntoView();
  next.querySelector('input')?.focus({preventScroll: true});
}

if (frames) {
  document.querySelector('.bar').hidden = false;
  document.querySelector('.bar').addEventListener('change', settle);
  for (const slider of frames.querySelectorAll('input[type=range]')) {
    slider.addEventListener('input', () => slider.parentElement.style.setProperty('--at', slider.value + '%'));
  }
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === 'j') step(1);
    if (event.key === 'k') step(-1);
    const mode = document.querySelector(`input[name=mode][data-key="${CSS.escape(event.key)}"]`);
    if (mode) {
      mode.checked = true;
      settle();
    }
  });
  settle();
}
